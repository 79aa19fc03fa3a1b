// LAR models, and elements of drawings.

#include "plumbline/structure/model.hpp"

#include <string>
#include <utility>

#include "core.hpp"
#include "model_arrays.hpp"
#include "plumbline/chains.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline::python {

Cells cells_of(const CellArrays& arrays) {
  const auto& [starts, indices] = arrays;
  Cells cells;
  const std::uint32_t* start = starts.data();
  if (starts.shape(0) == 0 || start[0] != 0 || start[starts.shape(0) - 1] != indices.shape(0)) {
    throw Error(ErrorCode::BadInput, "starts of cells that do not fit their vertices");
  }
  cells.reserve(starts.shape(0) - 1, indices.shape(0));
  for (std::size_t c = 0; c + 1 < starts.shape(0); ++c) {
    if (start[c] > start[c + 1] || start[c + 1] > indices.shape(0)) {
      throw Error(ErrorCode::BadInput, "starts of cells that do not ascend");
    }
    cells.push_back(std::span(indices.data() + start[c], start[c + 1] - start[c]));
  }
  return cells;
}

namespace {

using Coordinates = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

LarModel with_cells(LarModel model, const std::vector<CellArrays>& cells) {
  for (const CellArrays& array : cells) model.cells.push_back(cells_of(array));
  check(model);
  return model;
}

LarModel of_doubles(const Coordinates& coords, bool decimals,
                    const std::vector<CellArrays>& cells) {
  LarModel model;
  model.dimension = coords.shape(1);
  const std::size_t count = coords.shape(0) * coords.shape(1);
  model.coordinates.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double value = coords.data()[i];
    if (!std::isfinite(value)) {
      throw Error(ErrorCode::BadInput, "a coordinate that is not finite", {},
                  std::to_string(value));
    }
    model.coordinates.push_back(decimals ? parse_number(shortest_text(value))
                                         : Number(rational_from(value)));
  }
  return with_cells(std::move(model), cells);
}

LarModel of_texts(std::size_t dimension, const std::vector<std::string>& texts,
                  const std::vector<CellArrays>& cells) {
  LarModel model;
  model.dimension = dimension;
  for (const std::string& text : texts) model.coordinates.push_back(parse_number(text));
  return with_cells(std::move(model), cells);
}

DoubleArray coords(const LarModel& model) {
  std::vector<double> values;
  values.reserve(model.coordinates.size());
  for (const Number& coordinate : model.coordinates) values.push_back(nearest_double(coordinate));
  return array(std::move(values), model.dimension);
}

std::vector<Rational> point(const LarModel& model, std::size_t v) {
  if (v >= model.vertex_count()) throw nb::index_error("there are fewer vertices");
  std::vector<Rational> coordinates;
  for (const Number& coordinate : model.vertex(v)) coordinates.push_back(coordinate.rational());
  return coordinates;
}

ListArrays cells(nb::handle self, std::size_t k) {
  const auto& model = nb::cast<const LarModel&>(self);
  if (k >= model.cells.size()) throw nb::index_error("there are fewer arrays of cells");
  return view(model.cells[k], self);
}

void ensure_facets(const LarModel& model, std::size_t k) {
  if (k + 1 < model.cells.size()) return;
  throw Error(ErrorCode::BadInput, "a boundary needs two arrays of cells", {},
              std::to_string(model.cells.size()) + " there");
}

class Int32Array : public nb::object {
  NB_OBJECT(Int32Array, nb::object, "numpy.typing.NDArray[numpy.int32]", is_array)
 private:
  static bool is_array(PyObject*) { return true; }
};
using Csc =
    nb::typed<nb::tuple, Int32Array, Int32Array, Int32Array, nb::typed<nb::tuple, int, int>>;

/// (data, indices, indptr, shape), as SciPy's csc_array takes it.
Csc boundary(const LarModel& model, std::size_t k) {
  ensure_facets(model, k);
  ChainMatrix matrix = boundary_mod_2(model, k);
  matrix.makeCompressed();
  const auto nonzeros = static_cast<std::size_t>(matrix.nonZeros());
  const auto numbers = [](const int* first, std::size_t count) {
    return array(std::vector<std::int32_t>(first, first + count));
  };
  return nb::borrow<Csc>(nb::make_tuple(
      numbers(matrix.valuePtr(), nonzeros), numbers(matrix.innerIndexPtr(), nonzeros),
      numbers(matrix.outerIndexPtr(), static_cast<std::size_t>(matrix.cols()) + 1),
      nb::make_tuple(static_cast<std::size_t>(matrix.rows()),
                     static_cast<std::size_t>(matrix.cols()))));
}

DoubleArray element_coords(const Model& element) {
  std::vector<double> values;
  values.reserve(4 * element.segments.size());
  for (std::size_t i = 0; i < element.segments.size(); ++i) {
    for (const Number& number : element.segments.numbers(i)) {
      values.push_back(nearest_double(number));
    }
  }
  return array(std::move(values), 4);
}

std::vector<Rational> element_segment(const Model& element, std::size_t i) {
  if (i >= element.segments.size()) throw nb::index_error("there are fewer segments");
  std::vector<Rational> ends;
  for (const Number& number : element.segments.numbers(i)) ends.push_back(number.rational());
  return ends;
}

std::vector<std::string> texts_of(const Model& element) {
  std::vector<std::string> texts;
  for (const Model::Text& label : element.labels) texts.push_back(label.text);
  return texts;
}

std::string element_text(const Model& element) {
  const Source& source = element.source;
  std::string text = "<Element: " + source.element;
  if (!source.id.empty()) text += " " + source.id;
  return text + ", " + std::to_string(element.segments.size()) + " segments>";
}

void bind_operations(nb::class_<LarModel>& type) {
  type.def(
          "mapped", [](const LarModel& model, const Affine& map) { return apply(map, model); },
          nb::arg("map"), nb::call_guard<nb::gil_scoped_release>())
      .def(
          "embedded", [](const LarModel& model, int k) { return embed(model, k); }, nb::arg("k"),
          nb::call_guard<nb::gil_scoped_release>(), "With k coordinates 0 more, or -k fewer.")
      .def("boundary", &boundary, nb::arg("k"),
           "Facets x cells mod 2, as SciPy's csc_array takes it.")
      .def(
          "boundary_cells",
          [](const LarModel& model, std::size_t k) {
            ensure_facets(model, k);
            return array(boundary_cells(model, k));
          },
          nb::arg("k"), "The facets that an odd number of the cells hold.")
      .def("boundary_of_all", &boundary_of_all, nb::call_guard<nb::gil_scoped_release>())
      .def("boundary_polylines",
           [](const LarModel& model) { return arrays(boundary_polylines(model)); })
      .def(
          "to_json", [](const LarModel& model) { return to_json(model); },
          nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace

void bind_model(nb::module_& m) {
  nb::class_<LarModel> type(m, "LarModel", "Exact vertices of any dimension, and arrays of cells.");
  type.def_static("of_doubles", &of_doubles, nb::arg("coords"), nb::arg("decimals"),
                  nb::arg("cells"), "Of vertices (n, d); cells as (indptr, indices).")
      .def_static("of_texts", &of_texts, nb::arg("dimension"), nb::arg("texts"), nb::arg("cells"),
                  "Of decimals or fractions \"p/q\", as many per vertex as there are dimensions.")
      .def_ro("dimension", &LarModel::dimension, "Coordinates per vertex.")
      .def_prop_ro("vertex_count", &LarModel::vertex_count)
      .def_prop_ro("array_count", [](const LarModel& model) { return model.cells.size(); })
      .def("coords", &coords, nb::sig("def coords(self) -> numpy.typing.NDArray[numpy.float64]"),
           "Nearest doubles of the vertices, (n, d).")
      .def("point", &point, nb::arg("v"), "Exact coordinates of a vertex.")
      .def("cells", &cells, nb::arg("k"),
           "An array of cells as (indptr, indices), those of the highest dimension first.")
      .def_ro("source", &LarModel::source, "The element that it is.");
  define_equality(type);
  bind_operations(type);
  m.def("cuboids", &cuboids, nb::arg("shape"), nb::arg("skeletons"),
        nb::call_guard<nb::gil_scoped_release>(), "The grid of unit cubes.");

  nb::class_<Model>(m, "Element", "Segments of an element of a drawing, or of a table of rows.")
      .def_ro("source", &Model::source, "The element.")
      .def("__len__", [](const Model& element) { return element.segments.size(); })
      .def("__repr__", &element_text)
      .def("coords", &element_coords, "Nearest doubles of its segments, (n, 4).")
      .def("segment", &element_segment, nb::arg("i"), "ax, ay, bx, by, exactly.")
      .def_prop_ro(
          "rows",
          [](const Model& element) { return element.rows.empty() ? 1 : element.rows.size(); },
          "How many elements it is: those of a table.")
      .def_prop_ro("texts", &texts_of, "Its names, and texts that stand at places.");
}

}  // namespace plumbline::python

// The exact complex: its arrays, as they lie in memory; its exact numbers; what is asked of it.

#include "plumbline/complex.hpp"

#include <nanobind/stl/pair.h>

#include <algorithm>
#include <utility>

#include "core.hpp"
#include "plumbline/chains.hpp"

namespace plumbline::python {
namespace {

using Coordinates = nb::ndarray<const double, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;

const ExactComplex& complex_of(nb::handle self) { return nb::cast<const ExactComplex&>(self); }

/// A member of indices as a property: an array of the complex's own memory.
template <class Member>
auto as_view(Member Incidences::*member) {
  return [member](nb::handle self) { return view(complex_of(self).*member, self); };
}

DoubleArray coords_of(const ExactComplex& complex) {
  std::vector<double> coords;
  {
    const nb::gil_scoped_release release;
    coords.reserve(2 * complex.vertices.size());
    for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
      const PointD p = complex.vertices.nearest(v);
      coords.push_back(p.x);
      coords.push_back(p.y);
    }
  }
  return array(std::move(coords), 2);
}

Point point(const ExactComplex& complex, std::size_t v) {
  if (v >= complex.vertices.size()) throw nb::index_error("there are fewer vertices");
  return complex.vertices[v];
}

/// x, y numerators and denominators, (V, 4), where all fit; else None.
std::optional<IntArray> small_fractions(const ExactComplex& complex) {
  std::vector<std::int64_t> numbers;
  numbers.reserve(4 * complex.vertices.size());
  for (const Point& p : complex.vertices) {
    for (const mpz_class& part : {p.x.get_num(), p.x.get_den(), p.y.get_num(), p.y.get_den()}) {
      if (!part.fits_slong_p()) return std::nullopt;
      numbers.push_back(part.get_si());
    }
  }
  return array(std::move(numbers), 4);
}

/// Per edge the sources of the segments that cover it, ascending, each once.
ListArrays edge_items(const ExactComplex& complex, const SegmentSet& input) {
  Lists<std::uint32_t> items;
  {
    const nb::gil_scoped_release release;
    items.reserve(complex.edges.size(), complex.edge_sources.flat().size());
    std::vector<std::uint32_t> list;
    for (std::size_t e = 0; e < complex.edges.size(); ++e) {
      list.clear();
      for (const SegmentId s : complex.edge_sources[e]) {
        list.push_back(static_cast<std::uint32_t>(input.segment_source.at(s)));
      }
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      items.push_back(list);
    }
  }
  return arrays(std::move(items));
}

class Int32Array : public nb::object {
  NB_OBJECT(Int32Array, nb::object, "numpy.typing.NDArray[numpy.int32]", is_array)
 private:
  static bool is_array(PyObject*) { return true; }
};
using Shape = nb::typed<nb::tuple, int, int>;
using Csc = nb::typed<nb::tuple, Int32Array, Int32Array, Int32Array, Shape>;

/// A sparse matrix as SciPy's csc_array takes it: (data, indices, indptr, shape).
Csc csc(ChainMatrix matrix) {
  matrix.makeCompressed();
  const auto nonzeros = static_cast<std::size_t>(matrix.nonZeros());
  std::vector<std::int32_t> data(matrix.valuePtr(), matrix.valuePtr() + nonzeros);
  std::vector<std::int32_t> indices(matrix.innerIndexPtr(), matrix.innerIndexPtr() + nonzeros);
  std::vector<std::int32_t> starts(matrix.outerIndexPtr(),
                                   matrix.outerIndexPtr() + matrix.cols() + 1);
  return nb::borrow<Csc>(nb::make_tuple(array(std::move(data)), array(std::move(indices)),
                                        array(std::move(starts)),
                                        nb::make_tuple(static_cast<std::size_t>(matrix.rows()),
                                                       static_cast<std::size_t>(matrix.cols()))));
}

/// Per bounded face its vertices or edges, ascending: the rows of a characteristic matrix.
ListArrays rows_of(const ChainMatrix& matrix) {
  Lists<std::uint32_t> rows;
  const Eigen::SparseMatrix<int, Eigen::RowMajor> by_rows(matrix);
  std::vector<std::uint32_t> row;
  for (Eigen::Index f = 1; f < by_rows.rows(); ++f) {
    row.clear();
    for (Eigen::SparseMatrix<int, Eigen::RowMajor>::InnerIterator it(by_rows, f); it; ++it) {
      row.push_back(static_cast<std::uint32_t>(it.col()));
    }
    rows.push_back(row);
  }
  return arrays(std::move(rows));
}

IndexArray locate_points(const ExactComplex& complex, const Coordinates& coords) {
  std::vector<std::uint32_t> faces;
  {
    const nb::gil_scoped_release release;
    std::vector<Point> points;
    points.reserve(coords.shape(0));
    for (std::size_t i = 0; i < coords.shape(0); ++i) {
      points.push_back(exact(PointD{coords.data()[2 * i], coords.data()[2 * i + 1]}));
    }
    for (const FaceId f : locate_all(complex, points)) {
      faces.push_back(static_cast<std::uint32_t>(f));
    }
  }
  return array(std::move(faces));
}

DoubleArray area_doubles(const ExactComplex& complex) {
  std::vector<double> areas;
  {
    const nb::gil_scoped_release release;
    for (const Rational& area : face_areas(complex)) areas.push_back(nearest_double(area));
  }
  return array(std::move(areas));
}

void bind_arrays(nb::class_<ExactComplex>& type) {
  type.def("coords", &coords_of, "Nearest doubles of the vertices, (V, 2).")
      .def(
          "edges",
          [](nb::handle self) {
            const auto& edges = complex_of(self).edges;
            static_assert(sizeof(Edge) == 2 * sizeof(std::uint32_t));
            return view(reinterpret_cast<const std::uint32_t*>(edges.data()), edges.size(), 2,
                        self);
          },
          nb::sig("def edges(self) -> numpy.typing.NDArray[numpy.uint32]"))
      .def("edge_sources", as_view(&Incidences::edge_sources))
      .def("cycles", as_view(&Incidences::cycles))
      .def("face_outer", as_view(&Incidences::face_outer))
      .def("face_holes", as_view(&Incidences::face_holes))
      .def("face_isolated_vertices", as_view(&Incidences::face_isolated_vertices))
      .def("cycle_face", as_view(&Incidences::cycle_face))
      .def("halfedge_face", as_view(&Incidences::halfedge_face))
      .def("vertex_component", as_view(&Incidences::vertex_component))
      .def("component_parent", as_view(&Incidences::component_parent))
      .def("face_depth", [](nb::handle self) {
        const auto& depths = complex_of(self).face_depth;
        return view(depths.data(), depths.size(), 0, self);
      });
}

}  // namespace

void bind_complex(nb::module_& m) {
  nb::class_<Counts> counts_type(m, "Counts", "Numbers of cells; faces with the unbounded one.");
  counts_type.def_ro("vertices", &Counts::vertices)
      .def_ro("edges", &Counts::edges)
      .def_ro("faces", &Counts::faces)
      .def_ro("holes", &Counts::holes, "Of bounded faces.")
      .def_ro("isolated_vertices", &Counts::isolated_vertices)
      .def_ro("components", &Counts::components)
      .def_ro("antennas", &Counts::antennas, "Edges with the same face on both sides.")
      .def_ro("depth", &Counts::depth, "The greatest nesting depth.");
  counts_type.def("__repr__", [](const Counts& c) {
    return "<Counts: " + std::to_string(c.vertices) + " vertices, " + std::to_string(c.edges) +
           " edges, " + std::to_string(c.faces) + " faces, " + std::to_string(c.components) +
           " components, depth " + std::to_string(c.depth) + ">";
  });
  define_equality(counts_type);
  nb::class_<Violation>(m, "Violation", "An invariant of a complex that is broken.")
      .def_prop_ro("invariant", [](const Violation& v) { return to_text(v.invariant); })
      .def_ro("message", &Violation::message)
      .def_ro("where", &Violation::where)
      .def_ro("vertices", &Violation::vertices)
      .def_ro("edges", &Violation::edges)
      .def_ro("faces", &Violation::faces);
  nb::class_<FeatureSize>(m, "FeatureSize", "The least distances between cells, squared, exact.")
      .def_ro("squared_vertex_vertex", &FeatureSize::squared_vertex_vertex)
      .def_ro("v", &FeatureSize::v)
      .def_ro("w", &FeatureSize::w)
      .def_ro("squared_vertex_edge", &FeatureSize::squared_vertex_edge)
      .def_ro("vertex", &FeatureSize::vertex)
      .def_ro("edge", &FeatureSize::edge)
      .def("__repr__", [](const FeatureSize& f) {
        return "<FeatureSize: vertices " + shortest_text(nearest_sqrt(f.squared_vertex_vertex)) +
               " apart, vertex and edge " + shortest_text(nearest_sqrt(f.squared_vertex_edge)) +
               ">";
      });

  nb::class_<ExactComplex> type(m, "Complex", "A cellular complex with exact coordinates.");
  bind_arrays(type);
  type.def("point", &point, nb::arg("v"), "Exact coordinates of a vertex.")
      .def("small_fractions", &small_fractions)
      .def("edge_items", &edge_items, nb::arg("input"))
      .def("face_areas", &face_areas, nb::call_guard<nb::gil_scoped_release>())
      .def("face_area", &face_area, nb::arg("face"))
      .def("area_doubles", &area_doubles)
      .def("interior_point", &interior_point, nb::arg("face"))
      .def("counts", [](const ExactComplex& c) { return counts(c, c.vertices.size()); })
      .def(
          "signature", [](const ExactComplex& c) { return signature(c); },
          nb::call_guard<nb::gil_scoped_release>())
      .def(
          "validate", [](const ExactComplex& c) { return validate(c); },
          nb::call_guard<nb::gil_scoped_release>())
      .def("validate_coverage", &validate_coverage, nb::arg("input"),
           nb::call_guard<nb::gil_scoped_release>())
      .def(
          "feature_size", [](const ExactComplex& c) { return feature_size(c); },
          nb::call_guard<nb::gil_scoped_release>())
      .def("locate_points", &locate_points, nb::arg("coords"))
      .def(
          "locate", [](const ExactComplex& c, const Point& p) { return locate(c, p); },
          nb::arg("point"), nb::call_guard<nb::gil_scoped_release>())
      .def("boundary_1",
           [](const ExactComplex& c) { return csc(boundary_1(c, c.vertices.size())); })
      .def("boundary_2", [](const ExactComplex& c) { return csc(boundary_2(c)); })
      .def("face_edges", [](const ExactComplex& c) { return rows_of(characteristic_fe(c)); });
  define_equality(type);
}

}  // namespace plumbline::python

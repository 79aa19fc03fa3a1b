// The float pipelines of LAR, repaired and as published; models for them; random lines.

#include "plumbline/engines/lar.hpp"

#include <nanobind/stl/pair.h>

#include <array>
#include <string>
#include <utility>

#include "core.hpp"
#include "model_arrays.hpp"
#include "plumbline/chains.hpp"
#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/inters_show.hpp"
#include "plumbline/engines/inters_stages.hpp"
#include "plumbline/engines/lar_show.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline::python {
namespace {

using Points = nb::ndarray<const double, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;
using Pairs = nb::ndarray<const std::uint32_t, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;

DoubleArray coords_of(const std::vector<PointD>& points) {
  std::vector<double> coords;
  coords.reserve(2 * points.size());
  for (const PointD& p : points) {
    coords.push_back(p.x);
    coords.push_back(p.y);
  }
  return array(std::move(coords), 2);
}

DoubleArray coords_of(const std::vector<SegmentD>& segments) {
  std::vector<double> coords;
  coords.reserve(4 * segments.size());
  for (const SegmentD& s : segments) {
    for (const double c : {s.a.x, s.a.y, s.b.x, s.b.y}) coords.push_back(c);
  }
  return array(std::move(coords), 4);
}

IndexArray pairs_of(const std::vector<lar::VertexPair>& edges) {
  std::vector<std::uint32_t> pairs;
  pairs.reserve(2 * edges.size());
  for (const lar::VertexPair& edge : edges) {
    for (const VertexId v : edge) pairs.push_back(static_cast<std::uint32_t>(v));
  }
  return array(std::move(pairs), 2);
}

template <class Tag>
Lists<std::uint32_t> plain(const Lists<Index<Tag>>& lists) {
  Lists<std::uint32_t> result;
  result.reserve(lists.size(), lists.flat().size());
  std::vector<std::uint32_t> row;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    row.clear();
    for (const std::size_t index : lists[i]) row.push_back(static_cast<std::uint32_t>(index));
    result.push_back(row);
  }
  return result;
}

/// V, EV, FV.
using ModelArrays = nb::typed<nb::tuple, DoubleArray, IndexArray, ListArrays>;
ModelArrays arrays_of(const lar::Model& model) {
  return nb::borrow<ModelArrays>(
      nb::make_tuple(coords_of(model.vertices), pairs_of(model.edges), arrays(plain(model.faces))));
}

lar::Model model_of(const Points& points, const Pairs& edges, const CellArrays& faces) {
  lar::Model model;
  for (std::size_t v = 0; v < points.shape(0); ++v) {
    model.vertices.push_back({points.data()[2 * v], points.data()[2 * v + 1]});
    if (!std::isfinite(model.vertices.back().x) || !std::isfinite(model.vertices.back().y)) {
      throw Error(ErrorCode::BadInput, "a coordinate that is not finite");
    }
  }
  for (std::size_t e = 0; e < edges.shape(0); ++e) {
    model.edges.push_back({VertexId(edges.data()[2 * e]), VertexId(edges.data()[2 * e + 1])});
  }
  const Cells cells = cells_of(faces);
  for (std::size_t f = 0; f < cells.size(); ++f) {
    std::vector<VertexId> face;
    for (const std::uint32_t v : cells[f]) face.emplace_back(v);
    model.faces.push_back(face);
  }
  return model;
}

/// Per bounded face the vertices of its outer boundary as they are walked, then those of its holes;
/// edges that end within it left out.
ListArrays face_walks(const Incidences& complex) {
  Lists<std::uint32_t> walks;
  std::vector<std::uint32_t> walk;
  const auto add = [&](CycleId cycle) {
    for (const HalfedgeId h : complex.cycles[cycle]) {
      if (complex.is_antenna(edge_of(h))) continue;
      walk.push_back(static_cast<std::uint32_t>(complex.origin(h)));
    }
  };
  for (std::size_t f = 1; f < complex.face_outer.size(); ++f) {
    walk.clear();
    add(complex.face_outer[f]);
    for (const CycleId hole : complex.face_holes[f]) add(hole);
    walks.push_back(walk);
  }
  return arrays(std::move(walks));
}

ListArrays face_edges(const Incidences& complex) {
  const Eigen::SparseMatrix<int, Eigen::RowMajor> by_rows(characteristic_fe(complex));
  Lists<std::uint32_t> rows;
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

/// V, EV, FV (walks), FE of the complex.
using ComplexArrays = nb::typed<nb::tuple, DoubleArray, IndexArray, ListArrays, ListArrays>;
ComplexArrays arrays_of(const lar::Result& result) {
  const FloatComplex& complex = result.complex;
  std::vector<std::uint32_t> edges;
  edges.reserve(2 * complex.edges.size());
  for (const Edge& edge : complex.edges) {
    edges.push_back(static_cast<std::uint32_t>(edge.tail));
    edges.push_back(static_cast<std::uint32_t>(edge.head));
  }
  return nb::borrow<ComplexArrays>(nb::make_tuple(coords_of(complex.vertices),
                                                  array(std::move(edges), 2), face_walks(complex),
                                                  face_edges(complex)));
}

/// Where the published pipeline has no answer, why: what failed, and how.
std::string failure(const inters::Trace& trace) {
  for (const inters::Failure& f : trace.failures) {
    if (f.stage == "larFromLines" || f.stage == "largest" || trace.lar.edges.empty()) {
      return f.function + " raised " + f.error + ": " + f.message;
    }
  }
  return "larFromLines returned None: no edges form a cycle";
}

void bind_results(nb::module_& m) {
  nb::class_<lar::Result>(m, "LarResult", "A run of the repaired float pipeline of LAR.")
      .def(
          "arrays", [](const lar::Result& r) { return arrays_of(r); }, "V, EV, FV, FE.")
      .def_prop_ro("radius", [](const lar::Result& r) { return r.trace.radius; })
      .def_prop_ro("rounds", [](const lar::Result& r) { return r.trace.rounds.size(); })
      .def_prop_ro(
          "settled", [](const lar::Result& r) { return r.trace.settled; },
          "Whether the last round changed nothing.")
      .def(
          "violations", [](const lar::Result& r) { return validate(exact(r.complex)); },
          nb::call_guard<nb::gil_scoped_release>(), "What makes it no valid complex.")
      .def(
          "to_json", [](const lar::Result& r) { return to_json(r); },
          nb::call_guard<nb::gil_scoped_release>());
  nb::class_<inters::Trace>(m, "IntersTrace", "A run of the pipeline of LAR as published.")
      .def(
          "lar", [](const inters::Trace& t) { return arrays_of(t.lar); },
          "V, EV of lines2lar, and no faces.")
      .def_prop_ro("has_faces", [](const inters::Trace& t) { return bool(t.lar_from_lines); })
      .def(
          "lar_from_lines",
          [](const inters::Trace& t) {
            if (!t.lar_from_lines) {
              throw Error(ErrorCode::BadInput, "the published pipeline has no faces", {},
                          failure(t));
            }
            return arrays_of(*t.lar_from_lines);
          },
          "V, EV, FV.")
      .def_prop_ro("failure", &failure, "Why there is no answer.")
      .def_prop_ro(
          "aborted", [](const inters::Trace& t) { return t.largest && t.largest->aborted; },
          "Whether the walk of faces stopped, and the rest is missing.")
      .def(
          "to_json", [](const inters::Trace& t) { return to_json(t); },
          nb::call_guard<nb::gil_scoped_release>());
}

void bind_runs(nb::module_& m) {
  m.def(
      "lar_arrange",
      [](const SegmentSet& input, std::optional<double> radius, std::size_t threads) {
        return lar::arrange(input, {radius, threads});
      },
      nb::arg("input"), nb::arg("radius").none(), nb::arg("threads"),
      nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "inters_run",
      [](const SegmentSet& input, int decimals, double radius, bool unit_square,
         std::size_t threads) {
        return inters::run(
            unit_square ? inters::lines_on_unit_square(input, decimals) : inters::lines(input),
            {decimals, radius, threads});
      },
      nb::arg("input"), nb::arg("decimals"), nb::arg("radius"), nb::arg("unit_square"),
      nb::arg("threads"), nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "inters_svg_lines",
      [](const std::string& svg, bool rectangles_as_sides) {
        const inters::Vcode vcode(inters::kDecimals);
        return coords_of(inters::svg_to_lines(svg, rectangles_as_sides, vcode));
      },
      nb::arg("svg"), nb::arg("rectangles_as_sides"),
      "The lines (n, 4) that the published svg2lines reads.");
  m.def("lar_unit_square", &lar::to_unit_square, nb::arg("input"),
        nb::call_guard<nb::gil_scoped_release>(), "The drawing on the unit square, exactly.");
  m.def(
      "lar_preset_radius",
      [](const std::string& preset, const SegmentSet& input) {
        return preset_radius(preset, input);
      },
      nb::arg("preset"), nb::arg("input"));
  m.def(
      "lar_simplify",
      [](const Points& points, const Pairs& edges, const CellArrays& faces, double radius,
         bool published) {
        const lar::Model model = model_of(points, edges, faces);
        return arrays_of(published ? inters::simplify(model, radius)
                                   : lar::simplify(model, radius));
      },
      nb::arg("points"), nb::arg("edges"), nb::arg("faces"), nb::arg("radius"),
      nb::arg("published"));
  m.def(
      "face_walks", [](const ExactComplex& complex) { return face_walks(complex); },
      nb::arg("complex"), "Per bounded face the vertices of its boundaries as they are walked.");
  m.def(
      "random_lines",
      [](std::size_t n, double scaling, std::uint64_t seed) {
        std::vector<SegmentD> lines;
        {
          const nb::gil_scoped_release release;
          lines = random_lines(n, scaling, seed);
        }
        return coords_of(std::move(lines));
      },
      nb::arg("n"), nb::arg("scaling"), nb::arg("seed"));
}

}  // namespace

void bind_lar(nb::module_& m) {
  bind_results(m);
  bind_runs(m);
}

}  // namespace plumbline::python

// What is wrong with line work itself.

#include "plumbline/diagnose.hpp"

#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>

#include <map>
#include <utility>

#include "core.hpp"
#include "plumbline/output.hpp"
#include "table.hpp"

namespace plumbline::python {
namespace {

void bind_defect(nb::module_& m) {
  nb::class_<Defect>(m, "Defect", "One defect of line work.")
      .def_prop_ro(
          "kind", [](const Defect& d) { return to_text(d.kind); },
          "\"gap\", \"undershoot\", \"overshoot\", \"near-miss\", \"dangle\", ...")
      .def_ro("message", &Defect::message, "One sentence.")
      .def_ro("where", &Defect::where, "Exactly.")
      .def_ro("size", &Defect::size,
              "A length, distance or width, of nearly parallel edges the sine of the angle. "
              "Rounded.")
      .def_ro("squared_size", &Defect::squared_size, "Exactly, where it is the root of that.")
      .def_ro("area", &Defect::area, "Of a sliver, exactly.")
      .def_ro("open_area", &Defect::open_area,
              "Of a gap or undershoot: of the face that is open there. Rounded.")
      .def_ro("ring", &Defect::ring, "Of an invalid ring.")
      .def_ro("proposed_tolerance", &Defect::proposed_tolerance,
              "The least one that mends it; None: none does.")
      .def_ro("vertices", &Defect::vertices, "Of the arrangement.")
      .def_ro("edges", &Defect::edges, "Of the arrangement.")
      .def_ro("face", &Defect::face, "Of a sliver.")
      .def_ro("segments", &Defect::segments, "Of the lines, ascending.")
      .def("__repr__",
           [](const Defect& d) { return "<Defect: " + to_text(d.kind) + ": " + d.message + ">"; });
  nb::class_<Opening>(m, "Opening", "A way through that is as wide as a door; no defect.")
      .def_ro("where", &Opening::where, "Its middle, exactly.")
      .def_ro("width", &Opening::width, "Rounded.")
      .def_ro("squared_width", &Opening::squared_width, "Exactly.")
      .def_ro("vertices", &Opening::vertices, "Two loose ends, or the four corners.")
      .def_prop_ro(
          "across",
          [](const Opening& o) {
            std::vector<std::pair<VertexId, VertexId>> pairs;
            for (const Edge& e : o.across) pairs.emplace_back(e.tail, e.head);
            return pairs;
          },
          nb::sig("def across(self) -> list[tuple[int, int]]"),
          "Pairs of vertices from jamb to jamb: what would close it.")
      .def_ro("segments", &Opening::segments, "Those that end there, ascending.");
  nb::class_<ToleranceEffect>(m, "ToleranceEffect", "What a tolerance would do.")
      .def_ro("tolerance", &ToleranceEffect::tolerance)
      .def_ro("mended", &ToleranceEffect::mended, "Defects whose tolerance is no larger.")
      .def_ro("spares_detail", &ToleranceEffect::spares_detail,
              "Whether all edges that are part of no defect are longer.");
}

std::map<std::string, std::size_t> counts_by_kind(const Diagnosis& diagnosis) {
  std::map<std::string, std::size_t> result;
  for (std::size_t k = 0; k < kDefectKinds; ++k) {
    if (diagnosis.found[k] > 0) result[to_text(static_cast<DefectKind>(k))] = diagnosis.found[k];
  }
  return result;
}

Table defect_table(const Diagnosis& diagnosis, const SegmentSet& input) {
  return {{{defect_layer(diagnosis, input)}, input.crs, "", {}, input.unit}};
}

void bind_outputs(nb::class_<Diagnosis>& type) {
  type.def(
          "to_text",
          [](const Diagnosis& d, const SegmentSet& input, std::size_t limit) {
            return to_text(d, input, limit);
          },
          nb::arg("input"), nb::arg("limit"))
      .def(
          "to_json", [](const Diagnosis& d, const SegmentSet& input) { return to_json(d, input); },
          nb::arg("input"))
      .def(
          "to_svg",
          [](const Diagnosis& d, const SegmentSet& input, const ExactComplex& complex) {
            return to_svg(d, input, complex);
          },
          nb::arg("input"), nb::arg("complex"), nb::call_guard<nb::gil_scoped_release>())
      .def("table", &defect_table, nb::arg("input"), nb::call_guard<nb::gil_scoped_release>(),
           "Of the defects, and then the openings.");
}

}  // namespace

void bind_diagnose(nb::module_& m) {
  bind_defect(m);
  nb::class_<Diagnosis> type(m, "Diagnosis", "What is wrong with line work.");
  type.def_ro("within", &Diagnosis::within)
      .def_ro("defects", &Diagnosis::defects)
      .def_prop_ro("found", &counts_by_kind)
      .def_ro("tips", &Diagnosis::tips)
      .def_ro("shared_sides", &Diagnosis::shared_sides)
      .def_ro("openings", &Diagnosis::openings)
      .def_ro("squared_detail", &Diagnosis::squared_detail)
      .def_ro("tolerances", &Diagnosis::tolerances)
      .def_ro("cut_short", &Diagnosis::cut_short)
      .def("by_effect", [](const Diagnosis& d) { return by_effect(d); });
  bind_outputs(type);
  m.def(
      "diagnose",
      [](const SegmentSet& input, const ExactComplex& complex, std::optional<Rational> within,
         std::size_t most_listed, std::optional<std::pair<Rational, Rational>> doors) {
        DiagnoseOptions options;
        options.within = std::move(within);
        options.most_listed = most_listed;
        if (doors) options.doors = Range{doors->first, doors->second};
        return diagnose(input, complex, options);
      },
      nb::arg("input"), nb::arg("complex"), nb::arg("within").none(), nb::arg("most_listed"),
      nb::arg("doors").none(), nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace plumbline::python

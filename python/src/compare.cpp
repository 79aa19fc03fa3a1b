// Complexes held against each other: findings.

#include "plumbline/compare.hpp"

#include "core.hpp"
#include "plumbline/number.hpp"

namespace plumbline::python {
namespace {

void bind_finding(nb::module_& m) {
  nb::class_<Finding>(m, "Finding", "One disagreement. `where` is the place to look at.")
      .def_prop_ro(
          "kind", [](const Finding& f) { return to_text(f.kind); },
          "\"vertex\", \"edge\", \"face\", \"hole\" or \"complex\".")
      .def_prop_ro(
          "disagreement", [](const Finding& f) { return to_text(f.disagreement); },
          "\"missing\", \"extra\", \"merged\", \"split\", \"moved\", \"reshaped\", ...")
      .def_prop_ro(
          "invariant",
          [](const Finding& f) {
            return f.invariant ? std::optional(to_text(*f.invariant)) : std::nullopt;
          },
          "The invariant of a complex that the result breaks by itself, or None.")
      .def_ro("message", &Finding::message, "One sentence.")
      .def_ro("where", &Finding::where, "Exactly; of no meaning for the kind \"complex\".")
      .def_ro("exact_cells", &Finding::exact_cells,
              "Cells of the exact arrangement: indices of its vertices, edges or faces, of the "
              "kind \"hole\" of its cycles.")
      .def_ro("answer_cells", &Finding::float_cells, "The same in the answer.")
      .def_ro("distance", &Finding::distance, "How far things moved, rounded.")
      .def_ro("squared_distance", &Finding::squared_distance, "Its square, exactly.")
      .def_ro("area", &Finding::area, "In which the faces differ, exactly.")
      .def_ro("lies_in", &Finding::lies_in,
              "Of a face that is missing or extra the face of the other side at its place.")
      .def_ro("segments", &Finding::segments, "Segments of the lines, ascending.")
      .def_ro("because", &Finding::because,
              "Numbers, from 1, of earlier findings that it follows from.")
      .def("__repr__", [](const Finding& f) {
        return "<Finding: " + to_text(f.kind) + " " + to_text(f.disagreement) + ": " + f.message +
               ">";
      });
}

}  // namespace

void bind_compare(nb::module_& m) {
  bind_finding(m);
  nb::class_<Comparison>(m, "Comparison", "What two complexes agree and disagree about.")
      .def_ro("tolerance", &Comparison::tolerance, "Within which vertices match.")
      .def_prop_ro(
          "compared", [](const Comparison& c) { return to_text(c.compared); },
          "Which cells: \"all\", \"graph\", \"faces\" or \"some faces\".")
      .def_ro("edges_left_out", &Comparison::edges_left_out,
              "Exact ones that polygons do not have.")
      .def_ro("vertices_left_out", &Comparison::vertices_left_out, "The same.")
      .def_ro("exact_counts", &Comparison::exact_counts)
      .def_ro("answer_counts", &Comparison::float_counts)
      .def_ro("matched_vertices", &Comparison::matched_vertices, "One to one.")
      .def_ro("matched_edges", &Comparison::matched_edges, "One to one.")
      .def_ro("matched_faces", &Comparison::matched_faces, "Those with the same outer boundary.")
      .def_ro("largest_displacement", &Comparison::largest_displacement, "Of a matched vertex.")
      .def_ro("answer_valid", &Comparison::float_valid,
              "Whether the answer by itself is a valid complex.")
      .def_ro("findings", &Comparison::findings)
      .def_prop_ro("agree", &Comparison::agree, "Whether there are no findings.")
      .def("__bool__", &Comparison::agree)
      .def("__repr__", [](const Comparison& c) {
        const std::size_t n = c.findings.size();
        return n == 0 ? std::string("<Comparison: agree>")
                      : "<Comparison: disagree, " + std::to_string(n) +
                            (n == 1 ? " finding>" : " findings>");
      });
  m.def(
      "compare",
      [](const ExactComplex& a, const ExactComplex& b, double tolerance) {
        return compare(a, b, tolerance);
      },
      nb::arg("a"), nb::arg("b"), nb::arg("tolerance"), nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "nearest_double", [](const std::string& text) { return nearest_double(parse_number(text)); },
      nb::arg("text"), "Of a decimal or a fraction \"p/q\".");
}

}  // namespace plumbline::python

// At which radii a drawing falls together.

#include "plumbline/ladder.hpp"

#include <cmath>

#include "core.hpp"
#include "plumbline/number.hpp"
#include "plumbline/output.hpp"

namespace plumbline::python {

void bind_ladder(nb::module_& m) {
  nb::class_<LadderStep>(m, "LadderStep",
                         "A critical radius: from it on merging gives other numbers of cells.")
      .def_ro("squared_radius", &LadderStep::squared_radius, "Exactly.")
      .def_prop_ro(
          "radius", [](const LadderStep& s) { return std::sqrt(nearest_double(s.squared_radius)); },
          "Rounded.")
      .def_ro("vertices", &LadderStep::vertices, "From here on.")
      .def_ro("edges", &LadderStep::edges, "From here on.")
      .def_ro("faces", &LadderStep::faces, "From here on, with the unbounded one.")
      .def_ro("vertex", &LadderStep::vertex, "What is that near: this vertex")
      .def_ro("other_vertex", &LadderStep::other_vertex, "and this one,")
      .def_ro("edge", &LadderStep::edge, "or this edge.");
  nb::class_<ToleranceLadder>(m, "ToleranceLadder", "How a drawing falls together.")
      .def_ro("vertices", &ToleranceLadder::vertices)
      .def_ro("edges", &ToleranceLadder::edges)
      .def_ro("faces", &ToleranceLadder::faces)
      .def_ro("steps", &ToleranceLadder::steps)
      .def_ro("is_complete", &ToleranceLadder::is_complete)
      .def(
          "to_text",
          [](const ToleranceLadder& ladder, const ExactComplex& complex, std::size_t limit) {
            return to_text(ladder, complex, limit);
          },
          nb::arg("complex"), nb::arg("limit"), nb::call_guard<nb::gil_scoped_release>())
      .def(
          "to_svg",
          [](const ToleranceLadder& ladder, const RightRadii* radii) {
            return to_svg(ladder, radii == nullptr ? std::nullopt : std::optional(*radii));
          },
          nb::arg("radii").none(), nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "tolerance_ladder",
      [](const ExactComplex& complex, std::size_t max_steps, std::optional<double> largest) {
        return tolerance_ladder(complex, {max_steps, largest});
      },
      nb::arg("complex"), nb::arg("max_steps"), nb::arg("largest_radius").none(),
      nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace plumbline::python

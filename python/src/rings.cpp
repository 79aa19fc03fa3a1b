// Whether polygons are valid, and why not.

#include "plumbline/rings.hpp"

#include "core.hpp"

namespace plumbline::python {
namespace {

/// A problem with what needs the drawing to be said.
struct InvalidRing : RingProblem {
  std::string message;
  std::uint32_t item = 0, other_item = 0;  ///< sources of the two rings
};

std::uint32_t item_of(const SegmentSet& input, std::size_t ring) {
  return static_cast<std::uint32_t>(input.segment_source.at(input.rings.at(ring).first));
}

std::vector<InvalidRing> invalid_rings(const SegmentSet& input, const ExactComplex& complex) {
  std::vector<InvalidRing> result;
  for (RingProblem& problem : ring_problems(input, complex)) {
    std::string message = describe(problem, input);
    const std::uint32_t item = item_of(input, problem.ring);
    const std::uint32_t other = item_of(input, problem.other);
    result.push_back({std::move(problem), std::move(message), item, other});
  }
  return result;
}

}  // namespace

void bind_rings(nb::module_& m) {
  nb::class_<RingProblem>(m, "RingProblem", "Why a polygon is not valid, or a closed line simple.")
      .def_prop_ro(
          "fault", [](const RingProblem& p) { return to_text(p.fault); },
          "\"crossing\", \"ring not closed\", ...")
      .def_prop_ro(
          "jts_name", [](const RingProblem& p) { return jts_name(p.fault); },
          "In the words of JTS and GEOS: \"Self-intersection\", ...")
      .def_ro("ring", &RingProblem::ring, "The position of the ring among all of the lines.")
      .def_ro("other", &RingProblem::other, "That of the other one; of one alone the same.")
      .def_ro("where", &RingProblem::where, "Exactly.")
      .def_ro("until", &RingProblem::until,
              "Of rings that run along each other the last point, `where` being the first.")
      .def_ro("segments", &RingProblem::segments, "Of the rings, those there, ascending.");
  nb::class_<InvalidRing, RingProblem>(m, "InvalidRing", "A problem of a ring of an item.")
      .def_ro("message", &InvalidRing::message, "One sentence.")
      .def_ro("item", &InvalidRing::item, "The item that the ring belongs to.")
      .def_ro("other_item", &InvalidRing::other_item, "That of the other ring.")
      .def("__repr__", [](const InvalidRing& p) { return "<InvalidRing: " + p.message + ">"; });
  m.def("invalid_rings", &invalid_rings, nb::arg("input"), nb::arg("complex"),
        nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "ring_count", [](const SegmentSet& input) { return input.rings.size(); }, nb::arg("input"));
}

}  // namespace plumbline::python

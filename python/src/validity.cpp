// Which polygons are valid, and valid ones in their place.

#include "plumbline/validity.hpp"

#include <nanobind/stl/pair.h>

#include <utility>

#include "core.hpp"

namespace plumbline::python {
namespace {

SourceId item_of(const SegmentSet& input, const PolygonValidity& polygon) {
  return input.segment_source[first_segment(input, polygon)];
}

/// Per polygon its item, and what is wrong with it.
std::vector<std::pair<SourceId, std::vector<RingProblem>>> problems(const SegmentSet& input,
                                                                    const ExactComplex& complex) {
  std::vector<std::pair<SourceId, std::vector<RingProblem>>> result;
  for (PolygonValidity& polygon : validity(input, complex)) {
    const SourceId item = item_of(input, polygon);
    result.emplace_back(item, std::move(polygon.problems));
  }
  return result;
}

/// Per polygon its item, and the valid ones in its place.
std::vector<std::pair<SourceId, RegionPolygons>> made(const SegmentSet& input,
                                                      const ExactComplex& complex,
                                                      const std::string& meaning) {
  const ValidMeaning by = valid_meaning(meaning);
  std::vector<std::pair<SourceId, RegionPolygons>> result;
  for (const PolygonValidity& polygon : validity(input, complex)) {
    result.emplace_back(item_of(input, polygon), made_valid(input, polygon, by));
  }
  return result;
}

}  // namespace

void bind_validity(nb::module_& m) {
  m.def("problems_of_polygons", &problems, nb::arg("input"), nb::arg("complex"),
        nb::call_guard<nb::gil_scoped_release>(), "Per polygon its item, and its problems.");
  m.def("made_valid", &made, nb::arg("input"), nb::arg("complex"), nb::arg("meaning"),
        nb::call_guard<nb::gil_scoped_release>(), "Per polygon its item, and what it covers.");
}

}  // namespace plumbline::python

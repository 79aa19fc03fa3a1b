// Problems of rings, polygon by polygon.

#include "plumbline/validity.hpp"

#include <utility>

#include "plumbline/error.hpp"

namespace plumbline {

std::vector<PolygonValidity> validity(const SegmentSet& input, const ExactComplex& complex) {
  std::vector<PolygonValidity> result;
  std::vector<std::size_t> polygon_of(input.rings.size());  // number in `result`
  bool is_there = false;
  for (std::size_t r = 0; r < input.rings.size(); ++r) {
    const RingRole role = input.rings[r].role;
    if (role == RingRole::Polygon || role == RingRole::Line) {
      if (!is_there && !result.empty()) result.pop_back();
      is_there = false;
      result.push_back({r, r, {}});
    }
    ensure(!result.empty(), "holes and parts follow their polygon");
    result.back().last_ring = r;
    polygon_of[r] = result.size() - 1;
    is_there = is_there || input.rings[r].count > 0;
  }
  if (!is_there && !result.empty()) result.pop_back();
  for (RingProblem& problem : ring_problems(input, complex)) {
    result[polygon_of[problem.ring]].problems.push_back(std::move(problem));
  }
  return result;
}

SegmentId first_segment(const SegmentSet& input, const PolygonValidity& polygon) {
  std::size_t ring = polygon.first_ring;
  while (ring < polygon.last_ring && input.rings[ring].count == 0) ++ring;
  return SegmentId(input.rings[ring].first);
}

}  // namespace plumbline

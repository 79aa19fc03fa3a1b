#include "diagnose/closings.hpp"

#include <algorithm>

#include "plumbline/arrange.hpp"

namespace plumbline::diagnose_steps {

std::vector<std::optional<double>> open_areas(const SegmentSet& input,
                                              const std::vector<Closing>& closings,
                                              std::size_t count) {
  std::vector<std::optional<double>> result(count);
  if (closings.empty()) return result;
  SegmentSet closed;
  closed.segments = input.segments;
  for (const Closing& closing : closings) closed.segments.push_back({closing.a, closing.b});
  const ExactComplex complex = arrange(closed);
  const std::vector<Rational> areas = face_areas(complex);
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    // The closings come last.
    const SegmentId last = complex.edge_sources[e].back();
    if (last < input.segments.size()) continue;
    const FaceId left = complex.halfedge_face[halfedge(EdgeId(e), false)];
    const FaceId right = complex.halfedge_face[halfedge(EdgeId(e), true)];
    if (left == right) continue;
    const Rational& area = left == kUnbounded    ? areas[right]
                           : right == kUnbounded ? areas[left]
                                                 : std::min(areas[left], areas[right]);
    std::optional<double>& largest = result[closings[last - input.segments.size()].number];
    largest = std::max(largest, std::optional(nearest_double(area)));
  }
  return result;
}

}  // namespace plumbline::diagnose_steps

#include <algorithm>

#include "edits/moves.hpp"
#include "edits/steps.hpp"

namespace plumbline::edits {

std::vector<Breach> check_movement(const SegmentSet& input, const Repair& repair,
                                   const Replay& replay) {
  std::vector<Breach> result;
  const Moves moves(repair);
  for (std::size_t i = 0; i < repair.output.segments.size(); ++i) {
    const auto origins = repair.origins[i];
    if (origins.empty() || !replay.is_touched[origins[0]]) continue;
    std::vector<Segment> places = moves.added_to(origins);
    for (const SegmentId s : origins) places.push_back(input.segments[s]);
    const Rational bound = moves.bound(origins);
    const Segment segment = repair.output.segments[i];
    for (const Point& end : {segment.a, segment.b}) {
      const Rational moved = squared_distance(end, places);
      if (moved <= bound * bound) continue;
      result.push_back(
          {"segment " + std::to_string(i) + " of the output ends " + length_text(moved) +
               " away from the segments that it stands for, more than " + exact_text(bound),
           end,
           {}});
    }
  }
  return result;
}

}  // namespace plumbline::edits

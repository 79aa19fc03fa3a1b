#include <algorithm>

#include "plumbline/engines/inters_stages.hpp"

namespace plumbline::inters {

std::vector<Box> containment_boxes(std::span<const SegmentD> lines, const Vcode& vcode) {
  std::vector<Box> boxes;
  boxes.reserve(lines.size());
  for (const SegmentD& line : lines) {
    const SegmentD s = vcode.quantised(line);  // rounding keeps order: min and max come after
    boxes.push_back({std::min(s.a.x, s.b.x), std::min(s.a.y, s.b.y), std::max(s.a.x, s.b.x),
                     std::max(s.a.y, s.b.y)});
  }
  return boxes;
}

}  // namespace plumbline::inters

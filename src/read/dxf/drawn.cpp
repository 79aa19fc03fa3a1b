#include "read/dxf/drawn.hpp"

namespace plumbline::dxf {

void append_chain(SegmentList& segments, const std::vector<NumberPoint>& points) {
  for (std::size_t i = 1; i < points.size(); ++i) segments.push_back(points[i - 1], points[i]);
}

void append_ring(SegmentList& segments, const std::vector<NumberPoint>& points) {
  append_chain(segments, points);
  if (!points.empty()) segments.push_back(points.back(), points.front());
}

}  // namespace plumbline::dxf

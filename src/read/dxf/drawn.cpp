#include "read/dxf/drawn.hpp"

#include <utility>

namespace plumbline::dxf {

void append_chain(SegmentList& segments, const std::vector<NumberPoint>& points) {
  for (std::size_t i = 1; i < points.size(); ++i) segments.push_back(points[i - 1], points[i]);
}

void append_curve(DrawnEntity& drawn, const std::vector<NumberPoint>& chords, Curve curve) {
  curve.first = static_cast<std::uint32_t>(drawn.segments.size());
  curve.count = static_cast<std::uint32_t>(chords.size() - 1);
  append_chain(drawn.segments, chords);
  drawn.curves.push_back(std::move(curve));
}

void mirror_x(Ellipse& ellipse) {
  for (Point* p : {&ellipse.centre, &ellipse.u, &ellipse.v}) p->x = -p->x;
}

void append_ring(SegmentList& segments, const std::vector<NumberPoint>& points) {
  append_chain(segments, points);
  if (!points.empty()) segments.push_back(points.back(), points.front());
}

}  // namespace plumbline::dxf

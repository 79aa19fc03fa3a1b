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

void append(DrawnEntity& drawn, DrawnEntity more) {
  const auto first = static_cast<std::uint32_t>(drawn.segments.size());
  for (std::size_t i = 0; i < more.segments.size(); ++i) {
    const auto n = more.segments.numbers(i);
    drawn.segments.push_back(NumberPoint{n[0], n[1]}, NumberPoint{n[2], n[3]});
  }
  for (Curve& curve : more.curves) {
    curve.first += first;
    drawn.curves.push_back(std::move(curve));
  }
  for (Ring& ring : more.rings) {
    ring.first += first;
    drawn.rings.push_back(ring);
  }
  for (Substitution& item : more.replaced) drawn.replaced.push_back(std::move(item));
  for (Unusable& item : more.refused) drawn.refused.push_back(std::move(item));
}

void mirror_x(Ellipse& ellipse) {
  for (Point* p : {&ellipse.centre, &ellipse.u, &ellipse.v}) p->x = -p->x;
}

void append_ring(DrawnEntity& drawn, const std::vector<NumberPoint>& points) {
  const std::size_t first = drawn.segments.size();
  append_chain(drawn.segments, points);
  if (!points.empty()) drawn.segments.push_back(points.back(), points.front());
  end_ring(drawn, first);
}

void end_ring(DrawnEntity& drawn, std::size_t first) {
  const std::size_t count = drawn.segments.size() - first;
  if (count == 0) return;
  drawn.rings.push_back(
      {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count), RingRole::Line});
}

}  // namespace plumbline::dxf

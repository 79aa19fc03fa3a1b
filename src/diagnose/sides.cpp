#include "diagnose/sides.hpp"

#include <cmath>

namespace plumbline::diagnose_steps {
namespace {

/// The sign of a ring's area, positive where it runs counter-clockwise: doubles decide where they
/// can.
int direction(const SegmentList& segments, const Ring& ring) {
  constexpr double kRelativeError = 0x1p-48;  // of a product of two differences
  const PointD o = nearest(segments[ring.first].a);
  double sum = 0, sizes = 0, reach = 0;
  for (std::size_t s = ring.first; s < ring.first + ring.count; ++s) {
    const auto n = segments.numbers(s);
    const double ax = nearest_double(n[0]), ay = nearest_double(n[1]);
    const double bx = nearest_double(n[2]), by = nearest_double(n[3]);
    sum += (ax - o.x) * (by - o.y) - (ay - o.y) * (bx - o.x);
    const double far = std::abs(ax) + std::abs(ay) + std::abs(bx) + std::abs(by);
    sizes += (std::abs(ax - o.x) + std::abs(ay - o.y) + std::abs(bx - o.x) + std::abs(by - o.y)) *
             (far + std::abs(o.x) + std::abs(o.y));
    reach += std::abs(sum);
  }
  const double error = kRelativeError * (sizes + reach);
  if (std::abs(sum) > error) return sum > 0 ? 1 : -1;
  Rational area = 0;
  for (std::size_t s = ring.first; s < ring.first + ring.count; ++s) {
    const Segment side = segments[s];
    area += side.a.x * side.b.y - side.a.y * side.b.x;
  }
  return sgn(area);
}

}  // namespace

std::vector<SideOf> sides_of(const SegmentSet& input) {
  std::vector<SideOf> sides(input.segments.size());
  std::uint32_t polygon = 0;
  for (const Ring& ring : input.rings) {
    if (ring.role == RingRole::Polygon || ring.role == RingRole::Line) ++polygon;
    if (ring.count == 0) continue;
    const auto first = input.segments.numbers(ring.first);
    const auto last = input.segments.numbers(ring.first + ring.count - 1);
    if (last[2] != first[0] || last[3] != first[1]) continue;
    const int turn = direction(input.segments, ring);
    if (turn == 0) continue;
    const bool is_inside_left = (turn > 0) == (ring.role != RingRole::Hole);
    for (std::size_t s = ring.first; s < ring.first + ring.count; ++s) {
      const auto n = input.segments.numbers(s);
      const bool is_forth = n[0] != n[2] ? n[0] < n[2] : n[1] < n[3];
      sides[s] = {is_forth == is_inside_left ? Side::Left : Side::Right, polygon};
    }
  }
  return sides;
}

}  // namespace plumbline::diagnose_steps

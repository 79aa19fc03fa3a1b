#include "rings/ring_locator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::rings {
namespace {

/// A point in doubles, with room for its rounding.
BoxD around(const PointD& p) {
  constexpr double kSlack = 0x1p-50;
  const double room =
      kSlack * std::max(std::abs(p.x), std::abs(p.y)) + std::numeric_limits<double>::min();
  return grown({p, p}, room);
}

}  // namespace

RingLocator::RingLocator(const SegmentSet& input, const ExactComplex& complex, const Walk& walk)
    : input_(input), complex_(complex), walk_(walk), vertices_(walk.vertices), edges_(walk.edges) {
  std::sort(vertices_.begin(), vertices_.end());
  std::sort(edges_.begin(), edges_.end());
  const Ring& ring = input.rings[walk.ring];
  std::vector<BoxD> boxes;
  for (std::size_t s = ring.first; s < ring.first + ring.count; ++s) {
    const auto n = input.segments.numbers(s);
    BoxD box = around({nearest_double(n[0]), nearest_double(n[1])});
    const BoxD end = around({nearest_double(n[2]), nearest_double(n[3])});
    box.include(end.low);
    box.include(end.high);
    boxes.push_back(box);
    if (s == ring.first) box_ = box;
    box_.include(box.low);
    box_.include(box.high);
  }
  sides_ = std::make_unique<BoxTree>(boxes);
}

bool RingLocator::contains(const Point& p) const {
  BoxD ray = around(nearest(p));
  if (ray.low.x > box_.high.x) return false;
  ray.high.x = box_.high.x;
  bool is_inside = false;
  for (const std::size_t i : sides_->meeting(ray)) {
    const Segment side = input_.segments[input_.rings[walk_.ring].first + i];
    const bool is_a_above = side.a.y > p.y, is_b_above = side.b.y > p.y;
    if (is_a_above == is_b_above) continue;
    const int turn = orientation(side.a, side.b, p);
    if ((turn > 0) == is_b_above && turn != 0) is_inside = !is_inside;
  }
  return is_inside;
}

std::optional<Point> RingLocator::point_off(const Walk& other) const {
  for (const VertexId v : other.vertices) {
    if (!std::binary_search(vertices_.begin(), vertices_.end(), v)) return complex_.vertices[v];
  }
  for (const EdgeId e : other.edges) {
    if (std::binary_search(edges_.begin(), edges_.end(), e)) continue;
    const Point p = complex_.vertices[complex_.edges[e].tail],
                q = complex_.vertices[complex_.edges[e].head];
    return Point{(p.x + q.x) / 2, (p.y + q.y) / 2};
  }
  return std::nullopt;
}

}  // namespace plumbline::rings

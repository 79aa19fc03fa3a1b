#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// **Rounded**. Squares of what is very large or small overflow or underflow.
inline double squared_distance(const PointD& p, const PointD& q) {
  const double x = p.x - q.x, y = p.y - q.y;
  return x * x + y * y;
}
/// **Rounded**, without overflow or underflow on the way.
inline double distance(const PointD& p, const PointD& q) {
  return std::hypot(p.x - q.x, p.y - q.y);
}
/// The length of a vector as `distance` has it, within some units in the last place and sooner.
inline double quick_length(const PointD& v) {
  const double x = std::abs(v.x), y = std::abs(v.y);
  const double longer = std::max(x, y);
  if (longer == 0) return 0;
  const double ratio = std::min(x, y) / longer;
  return longer * std::sqrt(1 + ratio * ratio);
}

/// a + parameter (b - a), computed in this order.
inline PointD point_at(const SegmentD& s, double parameter) {
  return {s.a.x + parameter * (s.b.x - s.a.x), s.a.y + parameter * (s.b.y - s.a.y)};
}

/// The largest absolute coordinate; 0 for no points.
inline double largest_coordinate(std::span<const PointD> points) {
  double largest = 0;
  for (const PointD& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest;
}

/// An axis-parallel box of doubles.
struct BoxD {
  PointD low, high;

  void include(const PointD& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
  double longer_side() const { return std::max(width(), height()); }
};
/// The box around points. Requires: at least one.
inline BoxD box_of(std::span<const PointD> points) {
  BoxD box{points.front(), points.front()};
  for (const PointD& p : points) box.include(p);
  return box;
}

}  // namespace plumbline

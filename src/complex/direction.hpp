#pragma once

#include "plumbline/geometry.hpp"

namespace plumbline {

/// Exact circular order of directions, counter-clockwise from the positive x axis; no direction
/// (equal points, which only an invalid complex has) comes first.
class Direction {
 public:
  Direction(const Point& from, const Point& to)
      : dx_(to.x - from.x), dy_(to.y - from.y), half_(half()) {}
  friend bool operator<(const Direction& a, const Direction& b) {
    if (a.half_ != b.half_) return a.half_ < b.half_;
    return a.dx_ * b.dy_ > a.dy_ * b.dx_;
  }

 private:
  /// 1 for angles from 0 to below 180 degrees, 2 for the others, 0 for none.
  int half() const {
    if (sgn(dy_) != 0) return sgn(dy_) > 0 ? 1 : 2;
    return sgn(dx_) == 0 ? 0 : sgn(dx_) > 0 ? 1 : 2;
  }
  Rational dx_, dy_;
  int half_;
};

}  // namespace plumbline

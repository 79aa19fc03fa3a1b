#pragma once

#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline::rooms_steps {

/// A circle in a polygon: it meets no side.
struct Circle {
  PointD centre;
  double radius = 0;
};

/// The largest circle in a polygon with the given sides, holes' too, within 2 percent of its
/// radius; where it is smaller than `least`, one of radius 0 perhaps. **Rounded**. Cost: O(k) for
/// each square that is looked at; some dozens where the polygon is about as wide as its box,
/// many where it winds.
Circle inscribed_circle(const std::vector<SegmentD>& sides, double least);

}  // namespace plumbline::rooms_steps

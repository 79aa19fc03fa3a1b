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
/// radius and of `least` (where that is 0, a thousandth of the polygon); where it is smaller than
/// `least`, some smaller one. **Rounded**. Cost: for each square that is looked at the sides near
/// it; some dozens of squares where the polygon is about as wide as its box, about its area by the
/// square of `least` where it winds, 20,000 at most: then it is the largest one so far.
Circle inscribed_circle(const std::vector<SegmentD>& sides, double least);

}  // namespace plumbline::rooms_steps

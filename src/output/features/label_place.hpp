#pragma once

#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline::features {

/// Where a text fits into a polygon: its middle, and how wide and high the polygon is there.
struct LabelPlace {
  PointD middle;
  double width = 0, height = 0;
};

/// In the widest piece of some horizontal lines through the polygon, half-way between what is above
/// and below its middle: where a text of three times its height has most room. **Heuristic**.
/// Requires: rings, the outer one first. Degenerate: where doubles leave no room, a corner.
LabelPlace label_place(const std::vector<std::vector<PointD>>& rings);

}  // namespace plumbline::features

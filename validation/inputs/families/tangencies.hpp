#pragma once

#include "inputs/draw.hpp"

namespace plumbline::inputs {

/// Grids side by side that touch along a side or at a corner: of other steps, or sheared.
void tangent_grids(Draw& draw);
/// Polygons inside each other, each with corners on sides or corners of the one around it.
void rings_touching_at_points(Draw& draw);

}  // namespace plumbline::inputs

#pragma once

#include "inputs/draw.hpp"

namespace plumbline::inputs {

/// Segments that end at, go through, or miss by a tiny length the place where two others cross,
/// which is seldom a decimal.
void near_concurrent_fans(Draw& draw);
/// Polygons whose corners are drawn from a few places, each corner a tiny length off or not.
void near_coincident_corners(Draw& draw);
/// Segments that end exactly on slanted ones, or a tiny length before or behind, on both sides of
/// the same place; and others on those.
void t_junctions_on_slants(Draw& draw);

}  // namespace plumbline::inputs

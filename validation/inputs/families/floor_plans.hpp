#pragma once

#include "inputs/draw.hpp"

namespace plumbline::inputs {

/// Rooms between walls of two lines, with doors: openings in both lines, jambs, and a leaf that
/// swings by a rational angle; some walls end a tiny length off, some drawings are turned.
void floor_plan(Draw& draw);

}  // namespace plumbline::inputs

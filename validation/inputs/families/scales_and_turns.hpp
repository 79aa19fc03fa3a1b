#pragma once

#include "inputs/draw.hpp"

namespace plumbline::inputs {

/// Segments from 1e-9 to 1e9 long, each begun at an end or inside of another one.
void chain_of_scales(Draw& draw);
/// Segments on two or three lattices with a common point, turned against each other by angles with
/// rational sine and cosine.
void lattices_turned(Draw& draw);

}  // namespace plumbline::inputs

#pragma once

#include "inputs/draw.hpp"

namespace plumbline::inputs {

/// Segments from 1e-9 to 1e9 long, each begun at an end or inside of another one.
void chain_of_scales(Draw& draw);
/// Segments on two or three lattices with a common point, turned against each other by angles with
/// rational sine and cosine.
void lattices_turned(Draw& draw);
/// Corners of a lattice, each moved or not by a double between 2^-80 and 8: doubles of mixed
/// exponents, with ends that are one or all but one.
void mixed_doubles(Draw& draw);
/// A lattice turned and rounded to doubles: what was collinear or touched is so, or all but so.
void lattice_turned_in_doubles(Draw& draw);
/// A lattice, and a few segments far away or that go there, up to 1e40.
void lattice_and_strays(Draw& draw);

}  // namespace plumbline::inputs

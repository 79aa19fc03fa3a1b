#pragma once

#include <functional>

#include "plumbline/read.hpp"

namespace plumbline {

/// What chords of a drawing need not be nearer to their curves than, in the coordinates of the
/// curves: a 5000th of the longer side of its `extent`, over the largest factor by which a map
/// enlarges curves. Of a drawing of more than 2^22 segments, by the first ones. 0 for a drawing
/// without curves.
Rational drawing_tolerance(const Structure& structure);

/// What a reader makes of a drawing, and whether it had curves to flatten.
struct Reading {
  Structure structure;
  bool has_curves = false;
};
/// A reader, told what curves need not be nearer than.
using ReadFunction = std::function<Reading(const ReadOptions&, const Rational& least_tolerance)>;

/// The drawing as a reader of it gives it. Where the options leave the tolerance of curves to the
/// drawing, it is read coarsely first, then, if it has curves, within its tolerance.
Structure read_within_tolerance(const ReadOptions& options, const ReadFunction& read);

}  // namespace plumbline

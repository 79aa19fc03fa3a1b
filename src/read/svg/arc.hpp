#pragma once

#include <vector>

#include "read/flatten.hpp"

namespace plumbline {

/// An elliptical arc as path data give it.
struct SvgArc {
  Point from, to;
  Rational rx, ry;
  Rational rotation;    ///< of the ellipse's x axis, in degrees
  bool large = false;   ///< the arc of more than half the ellipse
  bool sweep = false;   ///< in the direction from +x to +y
  double rounding = 0;  ///< how far it may be from what the texts of its numbers were rounded from
};

/// The same by its ellipse, and what had to be replaced by how much (without source).
struct PlacedArc {
  EllipticArc arc;
  std::vector<Replacement> replaced;
  double bound = 0;  ///< how far they move it
};

/// The ellipse through both ends. **Exact** but for what `replaced` lists: an axis direction that
/// is not rational, by at most `bound` in radians, and a centre that is not, by multiplying both
/// radii with a factor within `bound` of 1. The ends are exact always. Degenerate: radii that are
/// too small are scaled up until the ellipse reaches both ends. Requires: from != to; radii not 0.
/// Source: SVG 1.1, F.6.
PlacedArc place_arc(const SvgArc& arc, double bound);

}  // namespace plumbline

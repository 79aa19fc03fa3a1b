#pragma once

#include "read/dxf/shapes.hpp"

namespace plumbline::dxf {

/// From group 50 to group 51, counter-clockwise; whole where they differ by a multiple of 360
/// degrees. Throws, like the others: Unusable.
DrawnEntity draw_arc(const Entity& entity, Pen& pen);
DrawnEntity draw_circle(const Entity& entity, Pen& pen);
/// From parameter 41 to 42, in radians; whole where they differ by a turn within the digits that
/// writers use, which goes into the ledger.
DrawnEntity draw_ellipse(const Entity& entity, Pen& pen);
/// The same from group 50 to 51, in degrees of its parameter, and in the entity's own coordinates.
DrawnEntity draw_ellipse_by_degrees(const Entity& entity, Pen& pen);
/// By its control points, knots and weights.
DrawnEntity draw_spline(const Entity& entity, Pen& pen);

/// What the ledger says of chords in place of a curve.
Substitution by_chords(const char* curve, double bound);

}  // namespace plumbline::dxf

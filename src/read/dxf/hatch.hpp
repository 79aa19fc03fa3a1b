#pragma once

#include "read/dxf/shapes.hpp"

namespace plumbline::dxf {

/// The boundaries of a HATCH: polylines with bulges, and paths of lines, arcs, parts of ellipses
/// and splines as LINE, ARC, ELLIPSE and SPLINE are drawn; frames of texts left out. Edges that
/// can't be drawn are `refused`. Throws: Unusable.
DrawnEntity draw_hatch(const Entity& entity, Pen& pen);

}  // namespace plumbline::dxf

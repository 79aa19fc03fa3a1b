#pragma once

#include "cases/foreign/foreign.hpp"
#include "cases/foreign/well_known_text.hpp"

namespace plumbline::foreign {

/// Validity as OGC SFA 1.2.1 and JTS define it, read off exact arrangements. **Exact**. Points
/// always are valid; lines are with two different points; polygons are if no piece of a line is
/// covered twice, no ring touches itself, each edge has the interior on one side, and each interior
/// is connected and meets no other. Repeated points are allowed.
bool is_valid(const Geometry& geometry);

/// Simplicity likewise: points differ; lines meet, each itself and the others, in ends only, those
/// of closed lines not among them; rings do not touch themselves.
bool is_simple(const Geometry& geometry);

/// What a boolean operation gives.
struct ClippedArea {
  Rational area;          ///< **exact**
  double perimeter = 0;   ///< **rounded**
  std::size_t edges = 0;  ///< of its boundary
};
ClippedArea clipped_area(const SegmentSet& input, const AreaClaim& claim);

}  // namespace plumbline::foreign

#pragma once

#include <string>
#include <vector>

#include "plumbline/structure/curve.hpp"
#include "read/attribute.hpp"

namespace plumbline::dxf {

/// A replacement of what the file says, by how much at most.
struct Substitution {
  std::string what;
  double bound = 0;
  const char* unit = "";
};

/// What one entity draws, in the coordinates of the space that holds it.
struct DrawnEntity {
  SegmentList segments;
  std::vector<Curve> curves;  ///< which segments are chords
  std::vector<Ring> rings;    ///< which segments are closed lines
  std::vector<Substitution> replaced;
  std::vector<Unusable> refused;  ///< parts that take no part
};

/// Appends the segments between successive points.
void append_chain(SegmentList& segments, const std::vector<NumberPoint>& points);
/// Appends the chords of a curve, whose `first` and `count` this sets.
void append_curve(DrawnEntity& drawn, const std::vector<NumberPoint>& chords, Curve curve);
/// Appends all of what another one draws.
void append(DrawnEntity& drawn, DrawnEntity more);
/// The curve as it is seen from +z, given in coordinates for -z.
void mirror_x(Ellipse& ellipse);
/// Appends the segments of the closed polygon, a ring.
void append_ring(DrawnEntity& drawn, const std::vector<NumberPoint>& points);
/// The segments from `first` on are a ring, if there are any.
void end_ring(DrawnEntity& drawn, std::size_t first);

}  // namespace plumbline::dxf

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {

/// Why a polygon is not valid, or what is wrong with a closed line (OGC SFA 1.2.1, 6.1.11.1).
/// `jts_name` has the words of JTS and GEOS.
enum class RingFault {
  NotClosed,     ///< a ring ends elsewhere than it starts
  TooFewPoints,  ///< a ring of less than three distinct points
  Crosses,       ///< two rings, or two parts of one, cross in a point
  RunsAlong,     ///< they share a piece of line; also a ring that goes back along itself
  Touches,       ///< a ring meets itself in a point without crossing itself
  HoleOutside,   ///< a hole outside the polygon, or the part, that it is in
  NestedHoles,   ///< a hole within another one
  NestedParts,   ///< a part within another one
  Disconnected,  ///< the interior falls apart where rings meet
};
inline constexpr std::size_t kRingFaults = 9;
/// "ring not closed", "crossing", ...
std::string to_text(RingFault fault);
/// "Self-intersection", "Ring Self-intersection", "Hole lies outside shell", ... as
/// TopologyValidationError of JTS has them, and `isValidDetail` of GEOS.
std::string jts_name(RingFault fault);

/// One fault. **Exact**.
struct RingProblem {
  RingFault fault = RingFault::NotClosed;
  std::size_t ring = 0, other = 0;  ///< indices into SegmentSet::rings; the same of one alone
  /// The end; the point; of what lies in another, a point of it; of a ring without length, a point
  /// of the polygon's other ring.
  Point where;
  std::optional<Point> until = {};       ///< of RunsAlong the last point, `where` being the first
  std::vector<SegmentId> segments = {};  ///< of the rings, those there, ascending
};

/// What is wrong with the rings of the input: nothing, just if all polygons are valid and all other
/// rings simple. Of rings that cross, nothing is said of which lies in which; of the parts of a
/// ring that run along each other one problem for each stretch. **Exact**. Requires: the complex is
/// `arrange(input)`; rings as readers make them. Order: by polygon, then fault and place. Cost: O(n
/// log n) for all pieces of the rings, but where boxes of rings overlap that do not contain each
/// other.
std::vector<RingProblem> ring_problems(const SegmentSet& input, const ExactComplex& complex);

/// One sentence on it: "hole 1 of Polygon #7 runs along its outer ring".
std::string describe(const RingProblem& problem, const SegmentSet& input);

}  // namespace plumbline

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {

/// A critical radius: from it on (it included) merging within the radius gives other numbers of
/// cells; the first one gives another graph, though its numbers may be the same.
struct LadderStep {
  Rational squared_radius;                         ///< exact
  std::size_t vertices = 0, edges = 0, faces = 0;  ///< from here on; faces with the unbounded one
  /// What is that near: two vertices, or a vertex and an edge that it does not bound. Of several
  /// such pairs the first that changes a number: those of vertices before those with edges, then by
  /// index.
  VertexId vertex;
  VertexId other_vertex;  ///< invalid where an edge is near
  EdgeId edge;            ///< invalid where two vertices are near
};

/// How a drawing falls together as the tolerance grows.
struct ToleranceLadder {
  std::size_t vertices = 0, edges = 0, faces = 0;  ///< at radius 0: those of the complex
  std::vector<LadderStep> steps;                   ///< ascending
  bool is_complete = true;  ///< whether it goes on until nothing changes any more
};

/// Where to end a ladder.
struct LadderOptions {
  std::size_t max_steps = 1000;
  std::optional<double> largest_radius;  ///< steps beyond it are left out
};

/// The tolerance ladder of a drawing: the critical radii at which its numbers of vertices, edges or
/// faces change when everything that is no further apart than the radius counts as one. For a
/// radius r,
///   - vertices no further apart than r are one, and so on along chains of them (transitively);
///   - an edge is led through each vertex that is no further than r from it and nearer to both its
///     ends than these are to each other (so that both parts are shorter than the edge), in the
///     order of the feet of the perpendiculars, where these coincide by (x, y);
///   - edges whose ends are one vanish; edges with the same two ends are one;
///   - faces are counted by Euler's relation, V - E + F = 1 + C with C connected components.
/// These are the decisions of the first round of `lar::arrange` on the edges of the complex
/// (validation/results/ladder.md), but that there a component that has become a point vanishes,
/// while it stays a vertex here. Run on the drawing, a pipeline may do more: a segment that ends
/// within the radius beyond another one is cut at its end and no more where they cross; and
/// vertices that move into the centroid of their cluster come near others. The graph is an abstract
/// one: a drawing of it with straight edges need not be planar. **Exact**: doubles propose pairs,
/// exact distances decide. Order: steps do not depend on how the drawing is moved, turned, mirrored
/// or scaled, unless feet coincide. Degenerate: a complex with at most one vertex has no steps. It
/// ends early, and says so by `is_complete`, as the options say, or where more than 2^21 pairs are
/// as near as makes no difference, or begin to matter at once. Requires: a valid complex. Cost: O(n
/// log n) and some microseconds for each pair within the last radius, but for those of an edge and
/// a vertex that is merged with an end of it where the edge passes no others. Throws: Error
/// BadInput for a largest radius that is negative or not a number.
ToleranceLadder tolerance_ladder(const ExactComplex& complex, const LadderOptions& options = {});

/// Places of a drawing that the digits of its file can't tell apart: different vertices, or
/// vertices beside edges, that are nearer than the roundings of both together
/// (`SegmentSet::rounding`).
struct Drift {
  std::size_t places = 0;   ///< vertices that are that near to each other or to an edge are one
  double largest = 0;       ///< distance of two of them; up to the rounding of a double
  double bound = 0;         ///< twice the largest rounding: none of them are further apart
  bool is_complete = true;  ///< false: there are more than kMostDrift pairs
  std::vector<VertexId> stands_for;  ///< per vertex the sharpest of its place; empty for no places
  std::vector<std::pair<EdgeId, VertexId>> beside;  ///< what edges would be led through
};
inline constexpr std::size_t kMostDrift = std::size_t{1} << 20U;

/// The drift of a drawing whose exact arrangement this is. Pairs are decided by exact distances. A
/// vertex is as sharp as the least sharp of its segments; crossings at small angles, which are less
/// sharp still, count for no more. **Requires**: a valid complex. Order: depends on the complex and
/// its segments' roundings alone. Cost: none where all numbers are short; else O(n log n) and some
/// microseconds a pair.
Drift drift(const SegmentSet& input, const ExactComplex& complex);
/// "printed doubles: 12 places, at most 7.2e-14 apart"; empty where there is none.
std::string to_text(const Drift& drift);

}  // namespace plumbline

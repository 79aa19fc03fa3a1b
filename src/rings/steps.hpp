#pragma once

#include <set>
#include <span>
#include <utility>
#include <vector>

#include "plumbline/rings.hpp"
#include "rings/walk.hpp"

namespace plumbline::rings {

/// A polygon of one part or several, or a closed line: what is looked at together.
struct Shape {
  const SegmentSet& input;
  const ExactComplex& complex;
  std::vector<Walk> walks;  ///< in the order of the rings; those of two segments left out
  /// Which part a walk belongs to, as the outer ring before it.
  std::vector<std::size_t> parts;
};

/// Where rings meet.
struct Meetings {
  std::vector<RingProblem> problems;
  std::set<std::pair<std::size_t, std::size_t>> crossing;  ///< walks, the lesser one first
};

/// Crosses, RunsAlong, Touches, Disconnected.
Meetings meetings(const Shape& shape);
/// HoleOutside, NestedHoles, NestedParts.
std::vector<RingProblem> nesting(const Shape& shape, const Meetings& meetings);

/// The segments of the two rings that cover one of the edges.
std::vector<SegmentId> segments_of(const Shape& shape, std::size_t ring, std::size_t other,
                                   std::span<const EdgeId> edges);

}  // namespace plumbline::rings

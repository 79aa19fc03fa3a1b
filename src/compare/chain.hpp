#pragma once

#include <vector>

#include "compare/sides.hpp"

namespace plumbline::compare_steps {

/// A walk on one side from vertex p to vertex q whose vertices in between lie within the tolerance
/// of the segment ab and advance along it, over edges for which `is_usable` is set. Empty if there
/// is none. **Exact**, but **heuristic** in that the search gives up after kMaxDeadEnds dead ends
/// or when `steps` are used up, which only a tolerance far larger than the drawing's features
/// brings about. `steps` is lessened by the edges looked at. Cost: the edges within the tolerance
/// of ab.
std::vector<HalfedgeId> chain_along(const Sides& sides, Side side, VertexId p, VertexId q,
                                    const Segment& ab, const std::vector<bool>& is_usable,
                                    std::size_t& steps);

inline constexpr std::size_t kMaxDeadEnds = 32;
/// Steps that all chains of a comparison together may take: per edge of both sides, and at least.
inline constexpr std::size_t kStepsPerEdge = 8, kLeastSteps = 20'000;

}  // namespace plumbline::compare_steps

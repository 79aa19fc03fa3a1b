#pragma once

#include "compare/steps.hpp"

namespace plumbline::compare_steps {

/// Pairs of vertices without a match that correspond all the same, by what they are joined to: the
/// exact one and the float one have the same degree, are the only ones that are joined to those
/// matched neighbours, and their edges to them have a segment in common (where both have sources).
/// Vertices found so are neighbours in turn. Before that, components whose vertices, ascending, are
/// joined in the same way correspond as wholes. **Heuristic**. Order: by exact vertex. Cost: O(n
/// log n) for n cells of components with vertices without a match.
std::vector<std::pair<VertexId, VertexId>> moved_vertices(const Sides& sides,
                                                          const Both<std::vector<VertexId>>& match);

}  // namespace plumbline::compare_steps

#pragma once

#include <optional>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {

/// Whether one sweep over the vertices proves that a complex keeps every invariant in the plane:
/// DuplicateVertex, DuplicateEdge, VertexOnEdge, Crossing, CyclicOrder, Orientation, Nesting, Area.
/// **Exact**: true just if it does. Requires: the invariants of the incidences alone hold. Cost:
/// O(n log n), nearly all of it in doubles.
bool is_certified(const ExactComplex& complex);

/// The edges next below and above a vertex that do not end at it; invalid where there are none.
struct EdgesBeside {
  EdgeId below, above;
};
/// The same for the graph alone, whose faces may be wrong: nothing unless it is proved to keep
/// DuplicateVertex, DuplicateEdge, VertexOnEdge and Crossing, else per vertex the edges beside it.
/// Requires: no violation of Index. Cost: O(n log n).
std::optional<std::vector<EdgesBeside>> edges_beside_vertices(const ExactComplex& complex);
/// Of these, the edge just below the least vertex of each component, if there is one.
std::optional<std::vector<std::optional<EdgeId>>> edges_below_components(
    const ExactComplex& complex);

}  // namespace plumbline

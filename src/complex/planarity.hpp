#pragma once

#include "plumbline/complex.hpp"

namespace plumbline {

/// Whether one sweep over the vertices proves that a complex keeps every invariant in the plane:
/// DuplicateVertex, DuplicateEdge, VertexOnEdge, Crossing, CyclicOrder, Orientation, Nesting, Area.
/// **Exact**: true just if it does. Requires: the invariants of the incidences alone hold. Cost:
/// O(n log n), nearly all of it in doubles.
bool is_certified(const ExactComplex& complex);

}  // namespace plumbline

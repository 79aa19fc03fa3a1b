#pragma once

#include <optional>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::round_steps {

/// An exact vertex that rounding carries past an edge: it was above the edge and is below all of
/// the edge's image at its x, or the other way round. Nothing where there is none. `chains` has
/// per exact edge the rounded vertices of its image, from tail to head. **Exact**. Requires: a
/// valid exact complex; rounded vertices ascending. Cost: O(n log n).
std::optional<VertexId> vertex_past_edge(const ExactComplex& exact, const ExactComplex& rounded,
                                         const std::vector<VertexId>& vertex_image,
                                         const Lists<VertexId>& chains);

}  // namespace plumbline::round_steps

#pragma once

#include <vector>

#include "plumbline/compare.hpp"

namespace plumbline::compare_steps {

/// What polygons alone can claim of an exact complex, and which of its cells that is.
struct Claims {
  ExactComplex complex;                    ///< in canonical order
  std::vector<VertexId> vertex;            ///< per vertex the one of the whole complex
  std::vector<std::vector<EdgeId>> edges;  ///< per edge those that it consists of there
  std::vector<FaceId> face;
  std::vector<CycleId> cycle;  ///< per cycle one that it has an edge of
  std::size_t edges_left_out = 0, vertices_left_out = 0;

  /// The finding with the cells of the whole complex.
  Finding of_whole(Finding finding) const;
};

/// The complex without edges that have the same face on both sides, and without vertices that no
/// other edge has: isolated ones, and those where such edges end in the middle of a straight side,
/// unless the other complex has a vertex there. **Exact**. Requires: a valid complex in canonical
/// order. Cost: O(n log n).
Claims claimed_by_polygons(const ExactComplex& complex, const ExactComplex& other,
                           double tolerance);

}  // namespace plumbline::compare_steps

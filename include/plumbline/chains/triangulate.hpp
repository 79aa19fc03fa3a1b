#pragma once

#include <array>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {

using Triangle = std::array<VertexId, 3>;  ///< counter-clockwise, the least vertex first

/// Triangles that fill a bounded face, holes left out: a constrained Delaunay triangulation of its
/// boundary. Its area is the face's by other means than cycles. **Exact**. Degenerate: antennas and
/// isolated vertices take no part. Order: ascending; where four vertices lie on a circle, which
/// triangles are taken is CGAL's choice. Requires: a valid complex. Cost: O(k log k) expected for k
/// edges of the face. Throws: Error BadInput for another face, and where edges cross. Source:
/// publication, section 2.11 (solid drawing).
std::vector<Triangle> triangulate(const ExactComplex& complex, FaceId face);

}  // namespace plumbline

#pragma once

#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::compare_steps {

/// The faces that contain the points, as `locate` tells one by one. **Exact**. Degenerate: the
/// complex need not be valid; then the face is that on the near side of the first edge to the
/// right. Cost: O(E log E), and for each point the edges that a horizontal line through it meets.
std::vector<FaceId> locate_all(const ExactComplex& complex, const std::vector<Point>& points);

}  // namespace plumbline::compare_steps

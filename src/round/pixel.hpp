#pragma once

#include "plumbline/geometry.hpp"

namespace plumbline::round_steps {

/// Whether the closed segment ab meets the pixel around `centre`: the square [-1/2, 1/2) of the
/// unit about it, in x and in y. **Exact**. Degenerate: a == b is a point.
bool meets_pixel(const Point& a, const Point& b, const Point& centre);

}  // namespace plumbline::round_steps

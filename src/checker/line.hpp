#pragma once

#include <gmpxx.h>

#include "number.hpp"

namespace plumbline_checker {

/// A line a x + b y = c in integers, with a direction: the lexicographically ascending one. The
/// doubles are about as large, each within 2^-52 of itself, or NaN if beyond 2^500.
struct Line {
  mpz_class a, b, c;
  double near_a = 0, near_b = 0, near_c = 0;
};

/// The line from one point to another. Requires: first < last in the lexicographic order.
Line line_through(const Point& first, const Point& last);

/// 1 if the point is on the left of the line, which is above it if that is not vertical, -1 on the
/// right or below, 0 on it. **Exact**. Cost: some nanoseconds, where doubles decide.
int side(const Line& line, const Point& point);

/// 1 if `b` points to the left of `a`, -1 to the right, 0 if they are parallel. **Exact**.
int turn(const Line& a, const Line& b);

}  // namespace plumbline_checker

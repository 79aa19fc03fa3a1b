#pragma once

#include <algorithm>
#include <cmath>

#include "number/half_unit.hpp"
#include "plumbline/geometry.hpp"

namespace plumbline {

/// How far a point may lie from the one that its text stands for: 0 where both numbers are short.
/// A long one was computed in doubles, by a few operations on numbers as large as the larger
/// coordinate, which leave two units in the last place of that open; then it was printed.
inline double text_rounding(const Number& x, const Number& y) {
  if (!is_long(x) && !is_long(y)) return 0;
  constexpr double kTwoUnits = 0x1p-51;
  const double computed =
      kTwoUnits * std::max(std::abs(nearest_double(x)), std::abs(nearest_double(y)));
  return std::hypot(half_unit(x) + computed, half_unit(y) + computed);
}
inline double text_rounding(const NumberPoint& p) { return text_rounding(p.x, p.y); }

}  // namespace plumbline

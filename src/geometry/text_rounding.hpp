#pragma once

#include <algorithm>
#include <cmath>

#include "number/half_unit.hpp"
#include "plumbline/geometry.hpp"

namespace plumbline {

/// How far a point may lie from the one that its text was rounded from: 0 where both numbers are
/// short. A long one was computed in doubles, which is no sharper than the larger coordinate's.
inline double text_rounding(const Number& x, const Number& y) {
  if (!is_long(x) && !is_long(y)) return 0;
  constexpr double kHalfUlp = 0x1p-53;
  const double largest = std::max(std::abs(nearest_double(x)), std::abs(nearest_double(y)));
  return std::max({half_unit(x), half_unit(y), kHalfUlp * largest});
}
inline double text_rounding(const NumberPoint& p) { return text_rounding(p.x, p.y); }

}  // namespace plumbline

#pragma once

#include "plumbline/round.hpp"

namespace plumbline::round_steps {

/// The distance of neighbours on the uniform grid: 10^-N, or that of doubles at the largest
/// absolute value of a coordinate (below the next power of two). Throws: Error BadInput.
Rational spacing(const ExactComplex& complex, const Grid& grid);

/// The integer i with value - 1/2 < i <= value + 1/2.
mpz_class nearest_integer(const Rational& value);

/// Whether the coordinate is a number of the grid.
bool is_on(const Grid& grid, const Rational& coordinate);

}  // namespace plumbline::round_steps

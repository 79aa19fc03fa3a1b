#include "round/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plumbline/error.hpp"

namespace plumbline {

std::string to_text(const Grid& grid) {
  if (!grid.decimals) return "nearest doubles";
  return std::to_string(*grid.decimals) + (*grid.decimals == 1 ? " decimal" : " decimals");
}

namespace round_steps {
namespace {

mpz_class power_of_ten(int exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
  return power;
}

/// The distance from the double to the next one away from 0.
Rational distance_of_doubles(double value) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double magnitude = std::abs(value);
  return rational_from(std::nextafter(magnitude, kInfinity)) - rational_from(magnitude);
}

}  // namespace

Rational spacing(const ExactComplex& complex, const Grid& grid) {
  if (grid.decimals) {
    if (*grid.decimals >= 0 && *grid.decimals <= Grid::kMaxDecimals) {
      return {1, power_of_ten(*grid.decimals)};
    }
    throw Error(
        ErrorCode::BadInput,
        "coordinates are rounded to 0 to " + std::to_string(Grid::kMaxDecimals) + " decimals", {},
        std::to_string(*grid.decimals));
  }
  double largest = 0;  // truncated, so below the next power of two just as the exact one is
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    const PointD p = complex.vertices.truncated(v);
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  return distance_of_doubles(largest);
}

mpz_class nearest_integer(const Rational& value) {
  mpz_class result;
  if (value.get_den() == 1) {
    result = value.get_num();
  } else {
    const mpz_class twice = 2 * value.get_num() + value.get_den();
    const mpz_class divisor = 2 * value.get_den();
    mpz_fdiv_q(result.get_mpz_t(), twice.get_mpz_t(), divisor.get_mpz_t());
  }
  return result;
}

bool is_on(const Grid& grid, const Rational& coordinate) {
  if (!grid.decimals) return rational_from(nearest_double(coordinate)) == coordinate;
  return power_of_ten(*grid.decimals) % coordinate.get_den() == 0;
}

}  // namespace round_steps
}  // namespace plumbline

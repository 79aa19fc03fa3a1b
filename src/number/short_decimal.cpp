#include "number/short_decimal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "number/half_unit.hpp"

namespace plumbline {

Number short_decimal(const Number& value) {
  if (!is_long(value)) return value;
  const double rounded = std::abs(nearest_double(value));
  if (!std::isnormal(rounded)) return value;
  const Rational decimal = parse_decimal(fmt::format("{:.{}e}", rounded, kShortDigits - 1));
  const Rational exact = value.rational();
  const Rational difference = abs(exact) - decimal;
  const double unit = std::nextafter(rounded, std::numeric_limits<double>::infinity()) - rounded;
  if (std::abs(nearest_double(difference)) > kDriftOfPrograms * unit) return value;
  return sgn(exact) < 0 ? Number(Rational(-decimal)) : Number(decimal);
}

}  // namespace plumbline

#include "number/half_unit.hpp"

#include <cmath>

namespace plumbline {

bool is_long(const Number& value) {
  return !value.is_decimal() || value.mantissa() >= kLeastLongMantissa ||
         value.mantissa() <= -kLeastLongMantissa;
}

double half_unit(const Number& value) {
  if (!value.is_decimal() || !is_long(value)) return 0;  // what has no place for it has 19 digits
  return 0.5 * std::pow(10.0, -value.digits());
}

}  // namespace plumbline

#include "number/bound_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "plumbline/number.hpp"

namespace plumbline {

std::string bound_text(double bound) {
  const auto two_digits = [](double value) {
    return nearest_double(parse_decimal(fmt::format("{:.1e}", value)));
  };
  double rounded = two_digits(bound);
  if (rounded < bound) {
    rounded = two_digits(bound + std::pow(10, std::floor(std::log10(bound)) - 1));
  }
  return shortest_text(rounded);
}

}  // namespace plumbline

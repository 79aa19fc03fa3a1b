#include "structure/map_rounding.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <variant>

#include "geometry/text_rounding.hpp"

namespace plumbline {
MapRounding::MapRounding(const Affine& map, double angle) {
  double sum = 0;
  for (const std::size_t row : {0, 1}) {
    for (const std::size_t column : {0, 1}) {
      const double entry = nearest_double(map(row, column));
      sum += entry * entry;
      if (is_long(map(row, column))) of_turn_ = std::max(angle, kUnit);
    }
    const Number& shift = map(row, 2);
    if (is_long(shift)) {
      of_shift_ = std::max(of_shift_, kUnit * std::abs(nearest_double(shift)));
    }
  }
  stretch_ = std::sqrt(sum);
}

double MapRounding::of(const Number& x, const Number& y) const {
  double rounding = text_rounding(x, y);
  if (of_turn_ > 0) rounding += of_turn_ * std::hypot(nearest_double(x), nearest_double(y));
  const double under_map = rounding == 0 ? of_shift_ : rounding * stretch_ + of_shift_;
  return std::isfinite(under_map) ? under_map : 0;  // of numbers beyond the doubles
}

double largest_angle(const Structure& structure) {
  const auto turns = [](const Struct& s) {
    return std::any_of(s.body.begin(), s.body.end(),
                       [](const Struct::Item& item) { return std::holds_alternative<Turn>(item); });
  };
  const bool has_turn = std::any_of(structure.structs.begin(), structure.structs.end(), turns);
  double largest = has_turn ? structure.angle_bound : 0;
  for (const Replacement& item : structure.ledger) {
    if (!std::string_view(item.bound).ends_with(" rad")) continue;
    largest = std::max(largest, std::strtod(item.bound.c_str(), nullptr));
  }
  return largest;
}

}  // namespace plumbline

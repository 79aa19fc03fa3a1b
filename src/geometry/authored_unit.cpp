#include "geometry/authored_unit.hpp"

#include <cmath>

#include "number/half_unit.hpp"

namespace plumbline {

void AuthoredUnit::add(const Number& number, double scale) {
  if (!number.is_decimal() || is_long(number)) return;
  if (last_ == nullptr || last_scale_ != scale) {
    last_ = &by_scale_[scale];
    last_scale_ = scale;
  }
  ++last_->all;
  ++last_->count[static_cast<std::size_t>(number.digits())];
}

double AuthoredUnit::unit() const {
  const Decimals* most = nullptr;
  double scale = 0;
  for (const auto& [factor, decimals] : by_scale_) {
    if (most != nullptr && decimals.all <= most->all) continue;
    most = &decimals;
    scale = factor;
  }
  if (most == nullptr) return 0;
  constexpr std::size_t kPart = 100;
  int digits = Number::kMaxDigits;
  while (digits > 0 && most->count[static_cast<std::size_t>(digits)] * kPart < most->all) --digits;
  return scale * std::pow(10.0, -digits);
}

}  // namespace plumbline

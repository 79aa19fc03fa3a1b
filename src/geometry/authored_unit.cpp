#include "geometry/authored_unit.hpp"

#include <cmath>

#include "number/half_unit.hpp"

namespace plumbline {

void AuthoredUnit::add(const Number& number, double scale) {
  if (!number.is_decimal() || is_long(number)) {
    ++long_;
    return;
  }
  if (last_ == nullptr || last_scale_ != scale) {
    last_ = &by_scale_[scale];
    last_scale_ = scale;
  }
  ++last_->all;
  const bool is_half = number.digits() > 0 && number.mantissa() % 10 % 5 == 0;
  ++(is_half ? last_->halves : last_->count)[static_cast<std::size_t>(number.digits())];
}

double AuthoredUnit::unit() const {
  const Decimals* most = nullptr;
  double scale = 0;
  for (const auto& [factor, decimals] : by_scale_) {
    if (most != nullptr && decimals.all <= most->all) continue;
    most = &decimals;
    scale = factor;
  }
  if (most == nullptr || most->all < long_) return 0;
  constexpr std::size_t kPart = 100;
  const auto is_used = [&](int digits) {
    const auto i = static_cast<std::size_t>(digits);
    const bool has_others = 2 * most->count[i] >= most->halves[i];
    return has_others && (most->count[i] + most->halves[i]) * kPart >= most->all;
  };
  int digits = Number::kMaxDigits;
  while (digits > 0 && !is_used(digits)) --digits;
  return scale * std::pow(10.0, -digits);
}

}  // namespace plumbline

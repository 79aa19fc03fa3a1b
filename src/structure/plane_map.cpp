#include "structure/plane_map.hpp"

#include <algorithm>
#include <utility>

namespace plumbline {
namespace {

mpz_class power_of_ten(int digits) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(digits));
  return power;
}

/// result = mantissa * 10^digits.
void scaled(mpz_class& result, std::int64_t mantissa, int digits) {
  result = static_cast<long>(mantissa);
  if (digits > 0) result *= power_of_ten(digits);
}

bool is_identity(const Affine& map) {
  static const Affine identity(2);
  return map == identity;
}

}  // namespace

PlaneMap::PlaneMap(const Affine& map)
    : map_(map),
      is_identity_(is_identity(map)),
      is_decimal_(std::all_of(map.entries().begin(), map.entries().end(),
                              [](const Number& entry) { return entry.is_decimal(); })) {
  if (is_decimal_) return;
  for (std::size_t i = 0; i < 2; ++i) {
    Row& row = rows_[i];
    row.denominator = 1;
    for (std::size_t j = 0; j < 3; ++j) {
      row.denominator = lcm(row.denominator, map(i, j).rational().get_den());
    }
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational entry = map(i, j).rational();
      row.numerators[j] = entry.get_num() * (row.denominator / entry.get_den());
    }
  }
}

NumberPoint PlaneMap::operator()(const NumberPoint& p) const {
  if (is_identity_) return p;
  if (!is_decimal_ && p.x.is_decimal() && p.y.is_decimal()) {
    return {image(rows_[0], p), image(rows_[1], p)};
  }
  const std::array<Number, 2> from{p.x, p.y};
  std::array<Number, 2> to;
  apply(map_, from, to);
  return {std::move(to[0]), std::move(to[1])};
}

Number PlaneMap::image(const Row& row, const NumberPoint& p) const {
  const int digits = std::max(p.x.digits(), p.y.digits());
  scaled(x_, p.x.mantissa(), digits - p.x.digits());
  scaled(y_, p.y.mantissa(), digits - p.y.digits());
  Rational result;
  mpz_ptr numerator = result.get_num_mpz_t();
  mpz_mul(numerator, row.numerators[0].get_mpz_t(), x_.get_mpz_t());
  mpz_addmul(numerator, row.numerators[1].get_mpz_t(), y_.get_mpz_t());
  if (digits == 0) {
    mpz_add(numerator, numerator, row.numerators[2].get_mpz_t());
    mpz_set(result.get_den_mpz_t(), row.denominator.get_mpz_t());
  } else {
    unit_ = power_of_ten(digits);
    mpz_addmul(numerator, row.numerators[2].get_mpz_t(), unit_.get_mpz_t());
    mpz_mul(result.get_den_mpz_t(), row.denominator.get_mpz_t(), unit_.get_mpz_t());
  }
  result.canonicalize();
  return result;
}

}  // namespace plumbline

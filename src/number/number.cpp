// Numbers: decimals in 64- and 128-bit integers, Rationals where these do not hold them.

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>

#include "number/leading_decimal.hpp"
#include "number/wide.hpp"
#include "plumbline/number.hpp"

namespace plumbline {
namespace {

using wide::Int128;
using wide::kPowersOfTen;

static_assert(sizeof(Number) == 16);

constexpr std::int64_t kMaxMantissa = std::numeric_limits<std::int64_t>::max();

bool is_mantissa(Int128 m) { return -kMaxMantissa <= m && m <= kMaxMantissa; }

/// The least number of digits that writes 1 / denominator as a decimal; more than kMaxDigits where
/// there is none up to that.
int decimal_digits(std::uint64_t denominator) {
  const int twos = std::countr_zero(denominator);
  denominator >>= static_cast<unsigned>(twos);
  int fives = 0;
  for (; denominator % 5 == 0; ++fives) denominator /= 5;
  return denominator == 1 ? std::max(twos, fives) : Number::kMaxDigits + 1;
}

mpz_class to_mpz(Int128 m) {
  mpz_class z = static_cast<long>(m >> 64);  // rounds down
  z <<= 64;
  z += static_cast<unsigned long>(m);
  return z;
}

/// m * 10^-digits with any digits >= 0.
Number decimal_of(Int128 m, int digits) {
  const auto is_held = [&] { return is_mantissa(m) && digits <= Number::kMaxDigits; };
  while (digits > 0 && !is_held() && m % 10 == 0) {
    m /= 10;
    --digits;
  }
  if (is_held()) return Number::decimal(static_cast<std::int64_t>(m), digits);
  Rational value(to_mpz(m));
  mpz_ui_pow_ui(value.get_den_mpz_t(), 10, static_cast<unsigned long>(digits));
  value.canonicalize();
  return value;
}

/// The mantissa of a decimal written with this many digits, not less than its own.
Int128 mantissa_at(const Number& a, int digits) {
  return Int128{a.mantissa()} * kPowersOfTen[digits - a.digits()];
}

}  // namespace

Number::Number(Rational value) {
  const mpz_srcptr n = value.get_num_mpz_t();
  const mpz_srcptr d = value.get_den_mpz_t();
  if (mpz_fits_slong_p(n) != 0 && mpz_fits_slong_p(d) != 0) {
    const long denominator = mpz_get_si(d);
    const int digits = decimal_digits(static_cast<std::uint64_t>(denominator));
    if (digits <= kMaxDigits) {
      const Int128 m = Int128{mpz_get_si(n)} * (kPowersOfTen[digits] / denominator);
      if (is_mantissa(m)) {
        held_.mantissa = static_cast<std::int64_t>(m);
        digits_ = digits;
        return;
      }
    }
  }
  held_.rational = new Rational(std::move(value));
  digits_ = kNoDecimal;
}

Number Number::decimal(std::int64_t mantissa, int digits) {
  while (digits > 0 && mantissa % 10 == 0) {
    mantissa /= 10;
    --digits;
  }
  if (!is_mantissa(mantissa)) {  // -2^63
    const Rational value = static_cast<long>(mantissa);
    return Rational(value / static_cast<long>(kPowersOfTen[digits]));
  }
  Number result;
  result.held_.mantissa = mantissa;
  result.digits_ = digits;
  return result;
}

Number::Held Number::copied() const {
  Held copy;
  copy.rational = new Rational(*held_.rational);
  return copy;
}

Rational Number::rational() const {
  if (!is_decimal()) return *held_.rational;
  // In lowest terms: of 2 and 5 at most one divides both, for else a digit could be spared.
  std::int64_t numerator = held_.mantissa;
  std::int64_t denominator = kPowersOfTen[digits_];
  const int twos = std::min(std::countr_zero(static_cast<std::uint64_t>(numerator)), digits_);
  numerator /= std::int64_t{1} << twos;
  denominator >>= twos;
  for (int i = 0; i < digits_ && numerator % 5 == 0; ++i) {
    numerator /= 5;
    denominator /= 5;
  }
  Rational value;
  mpz_set_si(value.get_num_mpz_t(), numerator);
  mpz_set_si(value.get_den_mpz_t(), denominator);
  return value;
}

namespace {

/// A Number as a Rational, made only where it is not held as one.
class View {
 public:
  explicit View(const Number& number)
      : made_(number.is_decimal() ? number.rational() : Rational()),
        seen_(number.is_decimal() ? made_ : number.held_rational()) {}

  const Rational& operator*() const { return seen_; }

 private:
  Rational made_;
  const Rational& seen_;
};

}  // namespace

std::strong_ordering operator<=>(const Number& a, const Number& b) {
  if (!a.is_decimal() || !b.is_decimal()) return cmp(*View(a), *View(b)) <=> 0;
  if (a.digits() == b.digits()) return a.mantissa() <=> b.mantissa();
  const int digits = std::max(a.digits(), b.digits());
  const Int128 m = mantissa_at(a, digits);
  const Int128 n = mantissa_at(b, digits);
  return m < n   ? std::strong_ordering::less
         : m > n ? std::strong_ordering::greater
                 : std::strong_ordering::equal;
}

int sgn(const Number& a) {
  if (!a.is_decimal()) return sgn(*a.held_.rational);
  return (a.mantissa() > 0) - (a.mantissa() < 0);
}

Number operator+(const Number& a, const Number& b) {
  if (!a.is_decimal() || !b.is_decimal()) return Rational(*View(a) + *View(b));
  const int digits = std::max(a.digits(), b.digits());
  return decimal_of(mantissa_at(a, digits) + mantissa_at(b, digits), digits);
}

Number operator-(const Number& a, const Number& b) {
  if (!a.is_decimal() || !b.is_decimal()) return Rational(*View(a) - *View(b));
  const int digits = std::max(a.digits(), b.digits());
  return decimal_of(mantissa_at(a, digits) - mantissa_at(b, digits), digits);
}

Number operator*(const Number& a, const Number& b) {
  if (!a.is_decimal() || !b.is_decimal()) return Rational(*View(a) * *View(b));
  return decimal_of(Int128{a.mantissa()} * b.mantissa(), a.digits() + b.digits());
}

Number parse_number(std::string_view text) {
  const LeadingDecimal decimal = leading_decimal(text);
  if (decimal.length == text.size() && !text.empty()) return decimal.value;
  return parse_decimal(text);
}

double nearest_double(const Number& value) {
  constexpr std::int64_t kExactIntegers = std::int64_t{1} << std::numeric_limits<double>::digits;
  if (!value.is_decimal() || std::abs(value.mantissa()) > kExactIntegers) {
    return nearest_double(value.rational());
  }
  // Powers of ten up to 10^22 are doubles, and IEEE division rounds correctly.
  return static_cast<double>(value.mantissa()) / static_cast<double>(kPowersOfTen[value.digits()]);
}

}  // namespace plumbline

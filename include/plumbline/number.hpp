#pragma once

#include <gmpxx.h>

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "plumbline/error.hpp"

namespace plumbline {

/// Exact rational number, always in lowest terms. The same type as CGAL::Exact_rational when CGAL
/// comes through its CMake target.
using Rational = mpq_class;

/// Longest number that `parse_decimal` accepts, counted in digits of its mantissa.
inline constexpr std::size_t kMaxDecimalDigits = 10'000;
/// Largest absolute value of a decimal exponent that `parse_decimal` accepts.
inline constexpr long kMaxDecimalExponent = 10'000;

/// An exact number as drawings hold it by the million: 16 bytes. A decimal `mantissa * 10^-digits`
/// with 0 <= digits <= kMaxDigits, the least possible, and |mantissa| < 2^63 is held in place; any
/// other rational number behind a pointer. Equal numbers are held in the same way. Sums,
/// differences and products are **exact**; Cost: some nanoseconds for decimals, as for Rationals
/// else.
class Number {
 public:
  static constexpr int kMaxDigits = 18;

  Number() = default;
  Number(Rational value);
  /// mantissa * 10^-digits. Requires: 0 <= digits <= kMaxDigits.
  static Number decimal(std::int64_t mantissa, int digits);
  Number(const Number& other)
      : held_(other.is_decimal() ? other.held_ : other.copied()), digits_(other.digits_) {}
  Number(Number&& other) noexcept : held_(other.held_), digits_(other.digits_) {
    other.digits_ = 0;
  }
  Number& operator=(Number other) noexcept {
    std::swap(held_, other.held_);
    std::swap(digits_, other.digits_);
    return *this;
  }
  ~Number() {
    if (!is_decimal()) delete held_.rational;
  }

  /// Whether it is held in place; it is then mantissa() * 10^-digits().
  bool is_decimal() const { return digits_ >= 0; }
  /// Requires: is_decimal().
  std::int64_t mantissa() const { return held_.mantissa; }
  int digits() const { return digits_; }
  Rational rational() const;
  /// Where it is held if not in place. Requires: !is_decimal().
  const Rational& held_rational() const { return *held_.rational; }

  friend bool operator==(const Number& a, const Number& b) {
    if (a.digits_ != b.digits_) return false;
    return a.is_decimal() ? a.mantissa() == b.mantissa() : *a.held_.rational == *b.held_.rational;
  }
  friend std::strong_ordering operator<=>(const Number& a, const Number& b);
  friend int sgn(const Number& a);
  friend Number operator+(const Number& a, const Number& b);
  friend Number operator-(const Number& a, const Number& b);
  friend Number operator*(const Number& a, const Number& b);

 private:
  union Held {
    std::int64_t mantissa = 0;
    const Rational* rational;  ///< owned
  };
  static constexpr std::int32_t kNoDecimal = -1;

  Held copied() const;

  Held held_{};
  std::int32_t digits_ = 0;  ///< or kNoDecimal
};

/// The rational number that a text denotes: a decimal (sign, digits with a point before, between or
/// after them, exponent, as in `-12.5e-3`; only digits are needed) or `p/q` with integers p and
/// q > 0. **Exact**. Degenerate: "-0" is 0. Surrounding blanks are not accepted. Cost: O(M(n)) for
/// n digits. Throws: Error BadInput (not a number), Limit (more than kMaxDecimalDigits digits, or
/// an exponent beyond kMaxDecimalExponent).
Rational parse_decimal(std::string_view text);
/// The same as a Number. Cost: some nanoseconds for a decimal without exponent of up to 18 digits.
Number parse_number(std::string_view text);

/// The dyadic rational that a finite double is. **Exact**. Requires: finite; throws Error BadInput.
Rational rational_from(double value);

/// The double nearest to `value`, ties to even. **Rounded** correctly, subnormals included; beyond
/// the largest double the result is an infinity, as IEEE 754 rounds. Never -0.
double nearest_double(const Rational& value);
double nearest_double(const Number& value);

/// The square root of a value >= 0 in doubles, within two units in the last place, whatever the
/// size of the value: 0 only for 0 and for roots below half the least double, an infinity beyond
/// the largest.
double nearest_sqrt(const Rational& value);

/// The shortest decimal text that reads back as the same double. -0 gives "0".
std::string shortest_text(double value);

/// The exact text of a rational: a plain decimal ("-0.125") where it is an integer or a decimal of
/// at most 40 digits, "p/q" in lowest terms elsewhere. `parse_decimal` reads both back, within its
/// limits.
std::string exact_text(const Rational& value);

/// The whole decimal expansion, however long: of a double up to 1076 digits. Requires: the value is
/// a decimal; throws Error BadInput.
std::string decimal_text(const Rational& value);

/// From one number to another, both included.
struct Range {
  Rational least, most;

  friend bool operator==(const Range&, const Range&) = default;
};

/// A unit of length.
struct LengthUnit {
  std::string name;  ///< "mm", "m", "in", ...
  Rational metres;   ///< exactly

  friend bool operator==(const LengthUnit&, const LengthUnit&) = default;
};

}  // namespace plumbline

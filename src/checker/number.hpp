#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <string_view>

namespace plumbline_checker {

/// Longest decimal or integer of a fraction in an input, in digits, and its largest exponent.
inline constexpr std::size_t kMaxInputDigits = 10'000;

/// An exact number in lowest terms, and where it is about: |near - it| <= 2^-50 |near|, or NaN if
/// its size is beyond 2^200 or below 2^-200 (so that no product of a few of them leaves the range
/// of doubles). Equal numbers have the same `near`.
struct Number {
  mpz_class numerator, denominator;  ///< denominator > 0
  double near = 0;

  Number() = default;
  /// Requires: lowest terms, denominator > 0.
  Number(mpz_class lowest_numerator, mpz_class lowest_denominator);

  friend bool operator==(const Number& a, const Number& b) {
    return !(a.near < b.near || a.near > b.near) && a.numerator == b.numerator &&
           a.denominator == b.denominator;
  }
};

struct Point {
  Number x, y;

  bool operator==(const Point&) const = default;
};

/// The number that a text of an input denotes: `[+-] (digits [. [digits]] | . digits) [(e|E) [+-]
/// digits]` or `p/q` with integers p and q > 0. None if it does not, or is too long.
std::optional<Number> input_number(std::string_view text);

/// The number that a text of a certificate denotes: an integer or a fraction in lowest terms, in
/// decimal, the one way to write it. None if it does not. Cost: that of a greatest common divisor.
std::optional<Number> canonical_number(std::string_view text);

/// Sign of a - b. **Exact**.
int compare(const Number& a, const Number& b);

/// The lexicographic order by (x, y). **Exact**.
int compare(const Point& a, const Point& b);
inline bool before(const Point& a, const Point& b) { return compare(a, b) < 0; }

/// "(1/2, 1/3)", numbers of more than a hundred letters cut short.
std::string text_of(const Point& point);

/// About z 2^-exponent with a relative error of at most 2^-52, its size being in [1/2, 1).
double leading_part(const mpz_class& z, long& exponent);

}  // namespace plumbline_checker

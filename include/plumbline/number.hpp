#pragma once

#include <gmpxx.h>

#include <string>
#include <string_view>

namespace plumbline {

/// Exact rational number, always in lowest terms. The same type as CGAL::Exact_rational when CGAL
/// comes through its CMake target.
using Rational = mpq_class;

/// Longest number that `parse_decimal` accepts, counted in digits of its mantissa.
inline constexpr std::size_t kMaxDecimalDigits = 10'000;
/// Largest absolute value of a decimal exponent that `parse_decimal` accepts.
inline constexpr long kMaxDecimalExponent = 10'000;

/// The rational number that a decimal text denotes: `[+-] (digits [. [digits]] | . digits) [(e|E)
/// [+-] digits]`, or `p/q` with integers p and q > 0. **Exact**. Degenerate: `-0` is 0. Surrounding
/// blanks are not accepted. Cost: O(M(n)) for n digits. Throws: Error BadInput (not a number),
/// Limit (more than kMaxDecimalDigits digits, or an exponent beyond kMaxDecimalExponent).
Rational parse_decimal(std::string_view text);

/// The dyadic rational that a finite double is. **Exact**. Requires: finite; throws Error BadInput.
Rational rational_from(double value);

/// The double nearest to `value`, ties to even. **Rounded** correctly, subnormals included; beyond
/// the largest double the result is an infinity, as IEEE 754 rounds. Never -0.
double nearest_double(const Rational& value);

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

}  // namespace plumbline

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "plumbline/number.hpp"

/// Integers of 128 bits: fractions of them, compared, rounded and in lowest terms without a number
/// in dynamic memory.
namespace plumbline::wide {

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

inline constexpr auto kPowersOfTen = [] {
  std::array<std::int64_t, Number::kMaxDigits + 1> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 10 * powers[i - 1];
  return powers;
}();

constexpr UInt128 magnitude(Int128 v) {
  return v < 0 ? -static_cast<UInt128>(v) : static_cast<UInt128>(v);
}

/// A 256-bit magnitude.
struct UInt256 {
  UInt128 high, low;
  friend bool operator==(const UInt256&, const UInt256&) = default;
  friend bool operator<(const UInt256& a, const UInt256& b) {
    return a.high != b.high ? a.high < b.high : a.low < b.low;
  }
};

inline UInt256 multiply(UInt128 a, UInt128 b) {
  const std::uint64_t a0 = static_cast<std::uint64_t>(a), a1 = static_cast<std::uint64_t>(a >> 64);
  const std::uint64_t b0 = static_cast<std::uint64_t>(b), b1 = static_cast<std::uint64_t>(b >> 64);
  const UInt128 low = static_cast<UInt128>(a0) * b0;
  const UInt128 mid1 = static_cast<UInt128>(a1) * b0, mid2 = static_cast<UInt128>(a0) * b1;
  const UInt128 high = static_cast<UInt128>(a1) * b1;
  const UInt128 mid =
      (low >> 64) + static_cast<std::uint64_t>(mid1) + static_cast<std::uint64_t>(mid2);
  return {high + (mid1 >> 64) + (mid2 >> 64) + (mid >> 64),
          (mid << 64) | static_cast<std::uint64_t>(low)};
}

/// The greatest common divisor; of 0 and a the other one.
UInt128 gcd(UInt128 a, UInt128 b);

/// Sign of a b - c d. **Exact** for every value above -2^127.
int compare_products(Int128 a, Int128 b, Int128 c, Int128 d);

/// The double nearest to n / d, ties to even. **Rounded** correctly. Requires: d > 0.
double nearest_quotient(Int128 n, Int128 d);
double nearest_quotient(const mpz_class& n, const mpz_class& d);
/// The same, where the first bits of both tell it.
std::optional<double> nearest_by_first_bits(mpz_srcptr n, mpz_srcptr d);

/// The double next to n / d towards 0, or the same, as `Rational::get_d`. Requires: d > 0.
double truncated_quotient(Int128 n, Int128 d);
double truncated_quotient(const mpz_class& n, const mpz_class& d);

/// The integer as GMP's.
mpz_class integer(Int128 v);

/// A fraction in lowest terms, d > 0.
struct Fraction {
  Int128 n, d;
};
/// n / d. **Exact**. Requires: d > 0.
Fraction lowest(Int128 n, Int128 d);
Rational quotient(Int128 n, Int128 d);
Rational quotient(const mpz_class& n, const mpz_class& d);
/// The same number, where 127 bits hold both its numerator and its denominator.
std::optional<Fraction> fraction(const Rational& value);

/// Appends what `Rational::get_str(base)` says of the fraction. Requires: base is 10 or 16.
void append_fraction(std::string& text, const Fraction& value, int base);
/// Appends what `exact_text` says of the fraction; appends nothing, and returns false, where that
/// is a decimal of more than 18 places, or 2^64 and above.
bool append_exact(std::string& text, const Fraction& value);

}  // namespace plumbline::wide

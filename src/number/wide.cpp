#include "number/wide.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace plumbline::wide {
namespace {

constexpr std::uint64_t high(UInt128 v) { return static_cast<std::uint64_t>(v >> 64); }
constexpr std::uint64_t low(UInt128 v) { return static_cast<std::uint64_t>(v); }

int trailing_zeros(UInt128 v) {
  return low(v) != 0 ? std::countr_zero(low(v)) : 64 + std::countr_zero(high(v));
}
int leading_zeros(UInt128 v) {
  return high(v) != 0 ? std::countl_zero(high(v)) : 64 + std::countl_zero(low(v));
}

/// Of odd numbers, by subtraction (Stein 1967).
std::uint64_t gcd_of_odd(std::uint64_t a, std::uint64_t b) {
  while (a != b) {
    const std::uint64_t difference = a > b ? a - b : b - a;
    b = a < b ? a : b;
    a = difference >> std::countr_zero(difference);
  }
  return a;
}
UInt128 gcd_of_odd(UInt128 a, UInt128 b) {
  while (a != b) {
    if (a < b) std::swap(a, b);
    if (high(a) == 0) return gcd_of_odd(low(a), low(b));
    a -= b;
    a >>= trailing_zeros(a);
  }
  return a;
}

int sign(Int128 v) { return (v > 0) - (v < 0); }

/// The first 53 bits of |n| / d, of value 2^ulp each, and some more: `rest` of 2 `half`, off by at
/// most kError.
struct Leading {
  std::uint64_t first, rest, half;
  int ulp;
};
constexpr std::uint64_t kError = 2;

/// The first 128 bits of a positive integer, the highest of them set, and how many it has.
struct Top {
  UInt128 bits;
  int length;
};
Top top(UInt128 v) {
  const int zeros = leading_zeros(v);
  return {v << zeros, 128 - zeros};
}
Top top(mpz_srcptr z) {
  const auto size = static_cast<mp_size_t>(mpz_size(z));
  const auto word = [&](mp_size_t i) { return i < size ? mpz_getlimbn(z, size - 1 - i) : 0; };
  const int zeros = std::countl_zero(word(0));
  UInt128 bits = (static_cast<UInt128>(word(0)) << 64 | word(1)) << zeros;
  if (zeros != 0) bits |= word(2) >> (64 - zeros);
  return {bits, 64 * static_cast<int>(size) - zeros};
}

// With n' and d' = |n| and d shifted to where their first bits are set, and q the quotient of the
// first 127 bits of n' and the first 64 of d': n' / d' 2^63 is between q - 2 (since q < 2^64 and
// what is left out of d' is below 2^-63 of it) and q + 2 (since what is left out of n' is below 1).
Leading leading_bits(const Top& n, const Top& d) {
  const auto q = low((n.bits >> 1) / high(d.bits));
  const int dropped = 64 - std::countl_zero(q) - std::numeric_limits<double>::digits;
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
  return {q >> dropped, q & (2 * half - 1), half, dropped + n.length - d.length - 63};
}
Leading leading_bits(Int128 n, Int128 d) {
  return leading_bits(top(magnitude(n)), top(magnitude(d)));
}

// Of a positive quotient; nothing where the first bits do not tell.
std::optional<double> nearest(const Leading& q) {
  if (q.rest + kError >= q.half && q.rest <= q.half + kError) return {};
  return std::ldexp(static_cast<double>(q.first + (q.rest > q.half ? 1 : 0)), q.ulp);
}
std::optional<double> truncated(const Leading& q) {
  if (q.rest < kError || q.rest + kError >= 2 * q.half) return {};
  return std::ldexp(static_cast<double>(q.first), q.ulp);
}

/// The same of integers of any size: nothing, too, where doubles are not as dense as elsewhere.
template <class Round>
std::optional<double> by_first_bits(mpz_srcptr n, mpz_srcptr d, Round round) {
  if (mpz_sgn(n) == 0) return 0;
  constexpr int kDense = 900;
  const Leading q = leading_bits(top(n), top(d));
  if (std::abs(q.ulp) > kDense) return {};
  const std::optional<double> size = round(q);
  return size && mpz_sgn(n) < 0 ? -*size : size;
}

/// n / d, not in lowest terms.
Rational fraction_of(const mpz_class& n, const mpz_class& d) {
  Rational result;
  result.get_num() = n;
  result.get_den() = d;
  return result;
}

UInt256 shifted(const UInt256& v, int bits) {
  if (bits == 0) return v;
  if (bits >= 128) return {v.low << (bits - 128), 0};
  return {(v.high << bits) | (v.low >> (128 - bits)), v.low << bits};
}

/// Whether |n| / d is less than first 2^ulp, which is next to it. Requires: first < 2^54. With
/// that, |n| 2^-ulp is about first d, below 2^181.
bool is_less(Int128 n, Int128 d, std::uint64_t first, int ulp) {
  const UInt256 left{0, magnitude(n)}, right = multiply(magnitude(d), first);
  return ulp < 0 ? shifted(left, -ulp) < right : left < shifted(right, ulp);
}

/// The least k such that d divides 10^k, if there is one.
std::optional<int> decimal_places(UInt128 d) {
  const int twos = trailing_zeros(d);
  int fives = 0;
  for (d >>= twos; d % 5 == 0; ++fives) d /= 5;
  if (d != 1) return {};
  return std::max(twos, fives);
}

void append(std::string& text, std::uint64_t v, int base = 10) {
  std::array<char, 20> digits;
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + 20, v, base).ptr);
}
/// With as many digits as told.
void append_padded(std::string& text, std::uint64_t v, int count, int base = 10) {
  std::array<char, 20> digits;
  const auto length = std::to_chars(digits.data(), digits.data() + 20, v, base).ptr - digits.data();
  text.append(static_cast<std::size_t>(count - length), '0');
  text.append(digits.data(), static_cast<std::size_t>(length));
}
void append_wide(std::string& text, UInt128 v, int base) {
  if (high(v) == 0) return append(text, low(v), base);
  if (base == 16) {
    append(text, high(v), base);
    return append_padded(text, low(v), 16, base);
  }
  constexpr int kDigits = 19;
  constexpr std::uint64_t kPower = 10'000'000'000'000'000'000U;  // 10^19
  append_wide(text, v / kPower, base);
  append_padded(text, low(v % kPower), kDigits);
}

void assign(mpz_ptr z, UInt128 v) {
  mpz_set_ui(z, high(v));
  if (high(v) != 0) mpz_mul_2exp(z, z, 64);
  mpz_add_ui(z, z, low(v));
}

}  // namespace

UInt128 gcd(UInt128 a, UInt128 b) {
  if (a < b) std::swap(a, b);
  if (b == 0) return a;
  a = (high(a) | high(b)) != 0 ? a % b : low(a) % low(b);  // as far as one division goes
  if (a == 0) return b;
  const int twos_of_a = trailing_zeros(a), twos_of_b = trailing_zeros(b);
  return gcd_of_odd(a >> twos_of_a, b >> twos_of_b) << std::min(twos_of_a, twos_of_b);
}

int compare_products(Int128 a, Int128 b, Int128 c, Int128 d) {
  const int left = sign(a) * sign(b), right = sign(c) * sign(d);
  if (left != right) return left < right ? -1 : 1;
  if (left == 0) return 0;
  const UInt256 p = multiply(magnitude(a), magnitude(b)), q = multiply(magnitude(c), magnitude(d));
  if (p == q) return 0;
  return (p < q) == (left > 0) ? -1 : 1;
}

double nearest_quotient(Int128 n, Int128 d) {
  if (n == 0) return 0;
  const std::optional<double> size = nearest(leading_bits(n, d));
  if (!size) return nearest_double(quotient(n, d));
  return n < 0 ? -*size : *size;
}

std::optional<double> nearest_by_first_bits(mpz_srcptr n, mpz_srcptr d) {
  return by_first_bits(n, d, nearest);
}

double nearest_quotient(const mpz_class& n, const mpz_class& d) {
  const auto by_bits = nearest_by_first_bits(n.get_mpz_t(), d.get_mpz_t());
  return by_bits ? *by_bits : nearest_double(fraction_of(n, d));
}

double truncated_quotient(Int128 n, Int128 d) {
  if (n == 0) return 0;
  Leading q = leading_bits(n, d);
  if (q.rest + kError >= 2 * q.half && !is_less(n, d, q.first + 1, q.ulp)) ++q.first;
  if (q.rest < kError && is_less(n, d, q.first, q.ulp)) {
    if (std::has_single_bit(q.first)) return quotient(n, d).get_d();  // it takes a smaller ulp
    --q.first;
  }
  const double size = std::ldexp(static_cast<double>(q.first), q.ulp);
  return n < 0 ? -size : size;
}

double truncated_quotient(const mpz_class& n, const mpz_class& d) {
  const auto by_bits = by_first_bits(n.get_mpz_t(), d.get_mpz_t(), truncated);
  return by_bits ? *by_bits : fraction_of(n, d).get_d();
}

Fraction lowest(Int128 n, Int128 d) {
  const auto divisor = static_cast<Int128>(gcd(magnitude(n), magnitude(d)));
  return divisor == 1 ? Fraction{n, d} : Fraction{n / divisor, d / divisor};
}

mpz_class integer(Int128 v) {
  mpz_class result;
  assign(result.get_mpz_t(), magnitude(v));
  if (v < 0) mpz_neg(result.get_mpz_t(), result.get_mpz_t());
  return result;
}

Rational quotient(Int128 n, Int128 d) {
  const Fraction f = lowest(n, d);
  Rational result;
  assign(result.get_num_mpz_t(), magnitude(f.n));
  assign(result.get_den_mpz_t(), magnitude(f.d));
  if (n < 0) mpz_neg(result.get_num_mpz_t(), result.get_num_mpz_t());
  return result;
}

Rational quotient(const mpz_class& n, const mpz_class& d) {
  Rational result = fraction_of(n, d);
  result.canonicalize();
  return result;
}

std::optional<Fraction> fraction(const Rational& value) {
  constexpr std::size_t kBits = 127;
  static_assert(GMP_NUMB_BITS == 64);
  const mpz_srcptr n = value.get_num_mpz_t(), d = value.get_den_mpz_t();
  if (mpz_sizeinbase(n, 2) > kBits || mpz_sizeinbase(d, 2) > kBits) return {};
  const auto integer = [](mpz_srcptr z) {
    return static_cast<Int128>((static_cast<UInt128>(mpz_getlimbn(z, 1)) << 64) |
                               mpz_getlimbn(z, 0));
  };
  return Fraction{mpz_sgn(n) < 0 ? -integer(n) : integer(n), integer(d)};
}

void append_fraction(std::string& text, const Fraction& value, int base) {
  if (value.n < 0) text += '-';
  append_wide(text, magnitude(value.n), base);
  if (value.d == 1) return;
  text += '/';
  append_wide(text, magnitude(value.d), base);
}

bool append_exact(std::string& text, const Fraction& value) {
  const std::optional<int> places = decimal_places(magnitude(value.d));
  if (!places || *places == 0) {
    append_fraction(text, value, 10);
    return true;
  }
  const UInt128 whole = magnitude(value.n) / magnitude(value.d);
  if (*places > Number::kMaxDigits || high(whole) != 0) return false;
  const Int128 factor = kPowersOfTen[static_cast<std::size_t>(*places)] / value.d;
  const UInt128 rest = magnitude(value.n) % magnitude(value.d) * magnitude(factor);
  if (value.n < 0) text += '-';
  append(text, low(whole));
  text += '.';
  append_padded(text, low(rest), *places);
  return true;
}

}  // namespace plumbline::wide

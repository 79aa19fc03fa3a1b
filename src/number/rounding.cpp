// Rational <-> double. mpq_get_d truncates, so rounding is done here on integers.

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "number/wide.hpp"
#include "plumbline/error.hpp"
#include "plumbline/number.hpp"

namespace plumbline {
namespace {

using Double = std::numeric_limits<double>;
static_assert(Double::is_iec559 && Double::digits == 53);

constexpr long kLargestExponent = Double::max_exponent - 1;        // 2^1023
constexpr long kLeastUlp = Double::min_exponent - Double::digits;  // 2^-1074
constexpr unsigned long kExactIntegers = 1UL << Double::digits;    // up to 2^53

bool is_exact_integer(const mpz_class& z) {
  return mpz_cmpabs_ui(z.get_mpz_t(), kExactIntegers) <= 0;
}

mpz_class shifted_left(const mpz_class& z, long bits) {
  mpz_class result;
  mpz_mul_2exp(result.get_mpz_t(), z.get_mpz_t(), static_cast<mp_bitcnt_t>(bits));
  return result;
}

long bit_count(const mpz_class& z) { return static_cast<long>(mpz_sizeinbase(z.get_mpz_t(), 2)); }

/// floor(log2(n / d)) for positive n and d.
long binary_exponent(const mpz_class& n, const mpz_class& d) {
  const long upper = bit_count(n) - bit_count(d);  // 2^(upper - 1) < n / d < 2^(upper + 1)
  const bool below = upper >= 0 ? n < shifted_left(d, upper) : shifted_left(n, -upper) < d;
  return below ? upper - 1 : upper;
}

/// n / d (both positive) in units of 2^ulp, rounded to the nearest integer, ties to even.
double rounded_quotient(const mpz_class& n, const mpz_class& d, long ulp) {
  const mpz_class dividend = shifted_left(n, std::max(-ulp, 0L));
  const mpz_class divisor = shifted_left(d, std::max(ulp, 0L));
  mpz_class quotient;
  mpz_class remainder;
  mpz_tdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), dividend.get_mpz_t(),
              divisor.get_mpz_t());
  const int half = cmp(mpz_class(2 * remainder), divisor);
  if (half > 0 || (half == 0 && mpz_odd_p(quotient.get_mpz_t()))) ++quotient;
  return quotient.get_d();  // at most 2^53, hence exact
}

}  // namespace

Rational rational_from(double value) {
  if (!std::isfinite(value)) {
    throw Error(ErrorCode::BadInput, "not a finite number", {}, shortest_text(value));
  }
  return Rational(value);
}

double nearest_double(const Rational& value) {
  if (sgn(value) == 0) return 0;
  if (is_exact_integer(value.get_num()) && is_exact_integer(value.get_den())) {
    return value.get_num().get_d() / value.get_den().get_d();  // IEEE division rounds correctly
  }
  const auto by_first_bits =
      wide::nearest_by_first_bits(value.get_num_mpz_t(), value.get_den_mpz_t());
  if (by_first_bits) return *by_first_bits;
  const mpz_class n = abs(value.get_num());
  const mpz_class& d = value.get_den();
  const long exponent = binary_exponent(n, d);
  double magnitude = 0;
  if (exponent > kLargestExponent) {
    magnitude = Double::infinity();
  } else if (exponent >= kLeastUlp - 1) {  // smaller than half the least subnormal rounds to 0
    const long ulp = std::max(exponent - (Double::digits - 1), kLeastUlp);
    magnitude = std::ldexp(rounded_quotient(n, d, ulp), static_cast<int>(ulp));
  }
  return sgn(value) < 0 && magnitude != 0 ? -magnitude : magnitude;
}

std::string shortest_text(double value) {
  std::array<char, 32> buffer;  // the longest is 24: -2.2250738585072014e-308
  if (value == 0) value = 0;    // -0 -> 0
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

double nearest_sqrt(const Rational& value) {
  if (sgn(value) <= 0) return 0;
  // value = m * 4^k with m near 1, so that the root is sqrt(m) * 2^k.
  const auto bits = [](mpz_srcptr z) { return static_cast<long>(mpz_sizeinbase(z, 2)); };
  const long k = (bits(value.get_num_mpz_t()) - bits(value.get_den_mpz_t())) / 2;
  Rational m;
  if (k >= 0) {
    mpq_div_2exp(m.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(2 * k));
  } else {
    mpq_mul_2exp(m.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-2 * k));
  }
  return std::ldexp(std::sqrt(nearest_double(m)), static_cast<int>(k));
}

}  // namespace plumbline

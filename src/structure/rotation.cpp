// Rational stand-ins for rotations by degrees and skews, each with a proof of its bound.

#include <mpfr.h>

#include <utility>

#include "plumbline/error.hpp"
#include "plumbline/structure/affine.hpp"
#include "structure/continued_fraction.hpp"

namespace plumbline {
namespace {

/// A number and how far it may be from the one meant.
struct Enclosed {
  Rational value;
  Rational error;
};

/// The multiple of `step` nearest to x, in steps.
mpz_class nearest_multiple(const Rational& x, int step) { return floor(x / step + Rational(1, 2)); }

/// tan (or cot) of an angle in degrees, 0 < degrees <= 45, computed with `precision` bits.
Enclosed tangent_at(const Rational& degrees, bool cotangent, mpfr_prec_t precision) {
  // Rounding pi, the product and the quotient leaves the angle with a relative error below 4 u,
  // u = 2^-precision. The condition number 2x / sin 2x of tan and cot on (0, pi/4] is at most
  // pi/2, and their own rounding adds u: below 8 u in all, of a result below 2^exponent.
  constexpr int kErrorBits = 3;
  mpfr_t x;
  mpfr_init2(x, precision);
  mpfr_const_pi(x, MPFR_RNDN);
  mpfr_mul_q(x, x, degrees.get_mpq_t(), MPFR_RNDN);
  mpfr_div_ui(x, x, 180, MPFR_RNDN);
  cotangent ? mpfr_cot(x, x, MPFR_RNDN) : mpfr_tan(x, x, MPFR_RNDN);
  Enclosed result;
  mpfr_get_q(result.value.get_mpq_t(), x);
  const long error_exponent = mpfr_get_exp(x) + kErrorBits - precision;
  mpfr_clear(x);
  result.error = 1;
  if (error_exponent < 0) {
    mpq_div_2exp(result.error.get_mpq_t(), result.error.get_mpq_t(), -error_exponent);
  } else {
    mpq_mul_2exp(result.error.get_mpq_t(), result.error.get_mpq_t(), error_exponent);
  }
  return result;
}

/// The first convergent within `bound` of tan(degrees). Requires: 0 < |degrees| < 90.
Rational tangent(const Rational& degrees, const Rational& bound) {
  constexpr mpfr_prec_t kFirstPrecision = 128;
  constexpr int kSlack = 1024;  // the part of the bound that MPFR's error may use up
  const bool steep = abs(degrees) > 45;
  const Rational angle = steep ? Rational(90 - abs(degrees)) : Rational(abs(degrees));
  Enclosed computed;
  mpfr_prec_t precision = kFirstPrecision;
  do {
    computed = tangent_at(angle, steep, precision);
    precision *= 2;
  } while (computed.error * kSlack > bound);
  const Rational result = first_convergent(computed.value, bound - computed.error);
  return sgn(degrees) < 0 ? Rational(-result) : result;
}

/// tan(degrees), exactly where it is -1, 0 or 1.
Enclosed skew_factor(const Rational& degrees, double bound) {
  const Rational allowed = checked_bound(bound);
  const Rational rest = degrees - 180 * nearest_multiple(degrees, 180);  // in [-90, 90)
  if (rest == -90) {
    throw Error(ErrorCode::BadInput, "skew by a right angle", {}, exact_text(degrees));
  }
  if (sgn(rest) == 0) return {0, 0};
  if (abs(rest) == 45) return {sgn(rest), 0};
  return {tangent(rest, allowed), allowed};
}

}  // namespace

ApproximateAffine rotation(const Rational& degrees, double bound) {
  const Rational allowed = checked_bound(bound);
  const mpz_class quarters = nearest_multiple(degrees, 90);
  const Rational rest = degrees - 90 * quarters;  // in [-45, 45)
  Rational cosine = 1;
  Rational sine = 0;
  if (sgn(rest) != 0) {
    // The angle is 2 atan(t) and atan has a slope of at most 1: t within bound / 2 is enough.
    const Rational t = tangent(rest / 2, allowed / 2);
    cosine = (1 - t * t) / (1 + t * t);
    sine = 2 * t / (1 + t * t);
  }
  for (auto i = mpz_fdiv_ui(quarters.get_mpz_t(), 4); i > 0; --i) {
    swap(cosine, sine);
    cosine = -cosine;
  }
  return {{cosine, sine, -sine, cosine, 0, 0}, sgn(rest) == 0 ? Rational(0) : allowed};
}

ApproximateAffine skew_x(const Rational& degrees, double bound) {
  const auto [factor, deviation] = skew_factor(degrees, bound);
  return {{1, 0, factor, 1, 0, 0}, deviation};
}

ApproximateAffine skew_y(const Rational& degrees, double bound) {
  const auto [factor, deviation] = skew_factor(degrees, bound);
  return {{1, factor, 0, 1, 0, 0}, deviation};
}

}  // namespace plumbline

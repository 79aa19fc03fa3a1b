// Rational rotations of space, and of the plane by radians, each with a proof of its bound.

#include <mpfr.h>

#include <algorithm>

#include "plumbline/structure/affine.hpp"
#include "structure/continued_fraction.hpp"

namespace plumbline {
namespace {

using Vector = std::array<Rational, 3>;

/// A quaternion up to a factor: w + x i + y j + z k.
struct Quaternion {
  Rational w;
  Vector v;
};

/// tan(x) / length where |tan(x)| <= 1, else (`cotangent`) length / tan(x): with x = scale * length
/// and length = sqrt(length2) in [1, 2).
struct HalfAngle {
  Rational value;
  Rational error;  ///< bound on the deviation of `value`
  bool cotangent;
};

HalfAngle half_angle(const Rational& scale, const Rational& length2, mpfr_prec_t precision) {
  // With u = 2^-precision: the root and the product leave x with a relative error below 3 u, so an
  // absolute one below 3 u 2^e for |x| < 2^e. Where the tangent (or cotangent) is at most 1 its
  // derivative is at most 2, and its own rounding adds u; dividing by (multiplying with) a length
  // below 2 known to 2 u at most doubles the error and adds 5 u: below 64 u 2^max(e, 0) in all.
  constexpr int kErrorBits = 6;
  mpfr_t x, length, result;
  for (mpfr_ptr number : {x, length, result}) mpfr_init2(number, precision);
  mpfr_set_q(length, length2.get_mpq_t(), MPFR_RNDN);
  mpfr_sqrt(length, length, MPFR_RNDN);
  mpfr_mul_q(x, length, scale.get_mpq_t(), MPFR_RNDN);
  mpfr_tan(result, x, MPFR_RNDN);
  HalfAngle half;
  half.cotangent = mpfr_cmpabs_ui(result, 1) > 0;
  if (half.cotangent) mpfr_cot(result, x, MPFR_RNDN);
  half.cotangent ? mpfr_mul(result, result, length, MPFR_RNDN)
                 : mpfr_div(result, result, length, MPFR_RNDN);
  mpfr_get_q(half.value.get_mpq_t(), result);
  const long size = mpfr_zero_p(x) != 0 ? 0 : std::max(mpfr_get_exp(x), mpfr_exp_t{0});
  for (mpfr_ptr number : {x, length, result}) mpfr_clear(number);
  half.error = 1;
  mpq_mul_2exp(half.error.get_mpq_t(), half.error.get_mpq_t(),
               static_cast<mp_bitcnt_t>(size + kErrorBits));
  mpq_div_2exp(half.error.get_mpq_t(), half.error.get_mpq_t(), static_cast<mp_bitcnt_t>(precision));
  return half;
}

/// The quaternion whose rotation is about exactly `axis_angle`, by its length within `bound`.
/// Requires: axis_angle != 0.
Quaternion quaternion(const Vector& axis_angle, const Rational& bound) {
  constexpr mpfr_prec_t kFirstPrecision = 128;
  constexpr int kSlack = 1024;  // the part of the bound that MPFR's error may use up
  Rational largest;
  for (const Rational& x : axis_angle) largest = std::max(largest, Rational(abs(x)));
  Vector axis;  // 1 <= length < 2
  Rational length2;
  for (std::size_t i = 0; i < 3; ++i) {
    axis[i] = axis_angle[i] / largest;
    length2 += axis[i] * axis[i];
  }
  // The angle is 2 atan(length * value) or 2 acot(value / length): its derivative is below 4.
  const Rational allowed = bound / 4;
  HalfAngle half;
  mpfr_prec_t precision = kFirstPrecision;
  do {
    half = half_angle(largest / 2, length2, precision);
    precision *= 2;
  } while (half.error * kSlack > allowed);
  const Rational value = first_convergent(half.value, allowed - half.error);
  if (half.cotangent) return {value, axis};
  return {1, {value * axis[0], value * axis[1], value * axis[2]}};
}

/// The rotation matrix of q: (w^2 - v.v) I + 2 v v^T + 2 w [v]_x, divided by w^2 + v.v.
Affine matrix(const Quaternion& q) {
  const auto& [w, v] = q;
  const Rational v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  const Rational norm = w * w + v2;
  Affine map(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    map(i, i) = Rational((w * w - v2 + 2 * v[i] * v[i]) / norm);
    map(i, j) = Rational((2 * v[i] * v[j] - 2 * w * v[k]) / norm);
    map(j, i) = Rational((2 * v[i] * v[j] + 2 * w * v[k]) / norm);
  }
  return map;
}

}  // namespace

ApproximateAffine rotation_in_space(const std::array<Rational, 3>& axis_angle, double bound) {
  const Rational allowed = checked_bound(bound);
  const auto is_zero = [](const Rational& x) { return sgn(x) == 0; };
  if (std::all_of(axis_angle.begin(), axis_angle.end(), is_zero)) return {Affine(3), 0};
  return {matrix(quaternion(axis_angle, allowed)), allowed};
}

ApproximateAffine rotation_in_radians(const Rational& radians, double bound) {
  const auto [map, deviation] = rotation_in_space({0, 0, radians}, bound);
  return {embed(map, -1), deviation};
}

}  // namespace plumbline

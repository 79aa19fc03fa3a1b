// Lines and the two predicates of the sweep: in doubles with a certified bound of the error, in
// integers where that does not decide.

#include "line.hpp"

#include <cmath>
#include <limits>

namespace plumbline_checker {
namespace {

double near_integer(const mpz_class& z) {
  constexpr long kLargestExponent = 500;
  long exponent = 0;
  const double leading = leading_part(z, exponent);
  if (exponent > kLargestExponent) return std::numeric_limits<double>::quiet_NaN();
  return std::ldexp(leading, static_cast<int>(exponent));
}

/// `sum` is a sum of at most three products, the sizes of which add up to `size`. Each product has
/// a relative error of less than 2^-52 + 2^-50 + 2^-53, its factors' and its own, the two additions
/// have one of 2^-53 of `size` each, and `size` itself less than 2^-48: together less than 2^-48.
/// Nothing under- or overflows, since factors are 0, or in [1, 2^500] and [2^-201, 2^201]. NaN
/// decides nothing.
int certain_sign(double sum, double size) {
  const double bound = 0x1p-48 * size;
  return sum > bound ? 1 : sum < -bound ? -1 : 0;
}

}  // namespace

Line line_through(const Point& first, const Point& last) {
  mpz_class scale = lcm(first.x.denominator, first.y.denominator);
  scale = lcm(scale, last.x.denominator);
  scale = lcm(scale, last.y.denominator);
  const auto scaled = [&](const Number& number) {
    return mpz_class(scale / number.denominator * number.numerator);
  };
  const mpz_class x = scaled(first.x);
  const mpz_class y = scaled(first.y);
  const mpz_class dx = scaled(last.x) - x;
  const mpz_class dy = scaled(last.y) - y;
  Line line{-scale * dy, scale * dx, dx * y - dy * x};
  line.near_a = near_integer(line.a);
  line.near_b = near_integer(line.b);
  line.near_c = near_integer(line.c);
  return line;
}

int side(const Line& line, const Point& point) {
  const double ax = line.near_a * point.x.near;
  const double by = line.near_b * point.y.near;
  const double size = std::abs(ax) + std::abs(by) + std::abs(line.near_c);
  if (const int sign = certain_sign(ax + by - line.near_c, size); sign != 0) return sign;
  const auto& [x, y] = point;
  if (x.denominator == y.denominator) {
    return sgn(mpz_class(line.a * x.numerator + line.b * y.numerator - line.c * x.denominator));
  }
  const mpz_class left = line.a * x.numerator - line.c * x.denominator;
  return sgn(mpz_class(left * y.denominator + line.b * y.numerator * x.denominator));
}

int turn(const Line& a, const Line& b) {
  const double first = a.near_a * b.near_b;
  const double second = a.near_b * b.near_a;
  if (const int sign = certain_sign(first - second, std::abs(first) + std::abs(second));
      sign != 0) {
    return sign;
  }
  return sgn(mpz_class(a.a * b.b - a.b * b.a));
}

}  // namespace plumbline_checker

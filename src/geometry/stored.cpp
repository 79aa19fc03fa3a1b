#include "geometry/stored.hpp"

#include <algorithm>
#include <optional>

#include "number/fixed_integer.hpp"
#include "number/wide.hpp"

namespace plumbline {
namespace {

using wide::Int128;

bool is_quotient(Int128 n, Int128 d, const Number& decimal) {
  return wide::compare_products(n, wide::kPowersOfTen[decimal.digits()], decimal.mantissa(), d) ==
         0;
}

/// a b - c d, where that and the products are integers of 128 bits.
std::optional<Int128> difference(Int128 a, Int128 b, Int128 c, Int128 d) {
  Int128 left = 0, right = 0, result = 0;
  if (__builtin_mul_overflow(a, b, &left) || __builtin_mul_overflow(c, d, &right) ||
      __builtin_sub_overflow(left, right, &result)) {
    return {};
  }
  return result;
}

/// A segment of decimals, all times one power of ten.
struct Scaled {
  Int128 ax, ay, bx, by, scale;
};
std::optional<Scaled> scaled(std::span<const Number, 4> segment) {
  int digits = 0;
  for (const Number& n : segment) {
    if (!n.is_decimal()) return {};
    digits = std::max(digits, n.digits());
  }
  const auto at = [&](const Number& n) {
    return Int128{n.mantissa()} * wide::kPowersOfTen[digits - n.digits()];
  };
  return Scaled{at(segment[0]), at(segment[1]), at(segment[2]), at(segment[3]),
                wide::kPowersOfTen[digits]};
}

/// In integers of a fixed size; nothing where they do not suffice.
std::optional<bool> is_on_line(const WidePoint& p, const Scaled& s) {
  const auto ux = difference(p.x, s.scale, s.ax, p.w), uy = difference(p.y, s.scale, s.ay, p.w);
  if (!ux || !uy) return {};
  return wide::compare_products(s.bx - s.ax, *uy, s.by - s.ay, *ux) == 0;
}
std::optional<bool> is_on_line(const LongPoint& p, const Scaled& s) {
  using Coordinate = FixedInteger<4>;  // its products with scaled coordinates have 6 words
  using Difference = FixedInteger<8>;
  for (const mpz_class* z : {&p.x, &p.y, &p.w}) {
    if (mpz_size(z->get_mpz_t()) > 4) return {};
  }
  const Coordinate x(p.x.get_mpz_t()), y(p.y.get_mpz_t()), w(p.w.get_mpz_t());
  const Difference ux = product(x, Coordinate(s.scale)) - product(Coordinate(s.ax), w);
  const Difference uy = product(y, Coordinate(s.scale)) - product(Coordinate(s.ay), w);
  return product(Difference(s.bx - s.ax), uy) == product(Difference(s.by - s.ay), ux);
}

}  // namespace

bool is_at(const PointList& points, std::size_t i, const Number& x, const Number& y) {
  const WidePoint* p = points.wide(i);
  if (p == nullptr || !x.is_decimal() || !y.is_decimal()) {
    return points[i] == Point{x.rational(), y.rational()};
  }
  return is_quotient(p->x, p->w, x) && is_quotient(p->y, p->w, y);
}

bool is_on_line(const PointList& points, std::size_t i, std::span<const Number, 4> segment) {
  if (const auto s = scaled(segment)) {
    const WidePoint* p = points.wide(i);
    const auto decided = p != nullptr ? is_on_line(*p, *s) : is_on_line(points.long_point(i), *s);
    if (decided) return *decided;
  }
  return orientation({segment[0].rational(), segment[1].rational()},
                     {segment[2].rational(), segment[3].rational()}, points[i]) == 0;
}

}  // namespace plumbline

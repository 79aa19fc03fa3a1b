#include "geometry/stored.hpp"

#include <algorithm>
#include <optional>

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

/// In machine integers; nothing where they do not suffice.
std::optional<bool> is_on_line(const WidePoint& p, std::span<const Number, 4> segment) {
  int digits = 0;
  for (const Number& n : segment) {
    if (!n.is_decimal()) return {};
    digits = std::max(digits, n.digits());
  }
  const auto scaled = [&](const Number& n) {
    return Int128{n.mantissa()} * wide::kPowersOfTen[digits - n.digits()];
  };
  const Int128 ax = scaled(segment[0]), ay = scaled(segment[1]), scale = wide::kPowersOfTen[digits];
  const auto ux = difference(p.x, scale, ax, p.w), uy = difference(p.y, scale, ay, p.w);
  if (!ux || !uy) return {};
  return wide::compare_products(scaled(segment[2]) - ax, *uy, scaled(segment[3]) - ay, *ux) == 0;
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
  if (const WidePoint* p = points.wide(i)) {
    if (const auto decided = is_on_line(*p, segment)) return *decided;
  }
  return orientation({segment[0].rational(), segment[1].rational()},
                     {segment[2].rational(), segment[3].rational()}, points[i]) == 0;
}

}  // namespace plumbline

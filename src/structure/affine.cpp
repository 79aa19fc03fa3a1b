#include "plumbline/structure.hpp"

namespace plumbline {
namespace {

/// p x + q y + r; most entries of the maps in drawings are 0.
Rational linear(const Rational& p, const Rational& x, const Rational& q, const Rational& y,
                const Rational& r) {
  Rational sum = p * x;
  if (sgn(q) != 0) sum += q * y;
  if (sgn(r) != 0) sum += r;
  return sum;
}

}  // namespace

Point apply(const Affine& map, const Point& p) {
  return {linear(map.a, p.x, map.c, p.y, map.e), linear(map.d, p.y, map.b, p.x, map.f)};
}

Affine compose(const Affine& outer, const Affine& inner) {
  const Rational zero;
  const Point origin = apply(outer, {inner.e, inner.f});
  return {linear(outer.a, inner.a, outer.c, inner.b, zero),
          linear(outer.b, inner.a, outer.d, inner.b, zero),
          linear(outer.a, inner.c, outer.c, inner.d, zero),
          linear(outer.b, inner.c, outer.d, inner.d, zero),
          origin.x,
          origin.y};
}

Affine translation(const Rational& dx, const Rational& dy) {
  Affine map;
  map.e = dx;
  map.f = dy;
  return map;
}

Affine scaling(const Rational& sx, const Rational& sy) {
  Affine map;
  map.a = sx;
  map.d = sy;
  return map;
}

}  // namespace plumbline

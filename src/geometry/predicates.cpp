#include <algorithm>

#include "plumbline/geometry.hpp"

namespace plumbline {

int orientation(const Point& p, const Point& q, const Point& r) {
  const Rational left = (q.x - p.x) * (r.y - p.y);
  const Rational right = (q.y - p.y) * (r.x - p.x);
  return sgn(Rational(left - right));
}

bool on_segment(const Point& p, const Point& q, const Point& r) {
  const auto [x_low, x_high] = std::minmax(p.x, q.x);
  const auto [y_low, y_high] = std::minmax(p.y, q.y);
  const bool in_box = x_low <= r.x && r.x <= x_high && y_low <= r.y && r.y <= y_high;
  return in_box && orientation(p, q, r) == 0;
}

Rational squared_distance(const Point& p, const Point& q) {
  const Rational dx = p.x - q.x;
  const Rational dy = p.y - q.y;
  return dx * dx + dy * dy;
}

Rational squared_distance(const Point& p, const Point& a, const Point& b) {
  const Rational ux = b.x - a.x;
  const Rational uy = b.y - a.y;
  const Rational along = ux * (p.x - a.x) + uy * (p.y - a.y);
  const Rational length2 = ux * ux + uy * uy;
  if (along <= 0) return squared_distance(p, a);  // covers a == b
  if (along >= length2) return squared_distance(p, b);
  const Rational across = ux * (p.y - a.y) - uy * (p.x - a.x);
  return across * across / length2;
}

}  // namespace plumbline

// The points a + t (b - a), 0 <= t <= 1, in the pixel are those of an interval of t, which the four
// sides cut out: the lower ones belong to the pixel, the upper ones do not.

#include "round/pixel.hpp"

namespace plumbline::round_steps {
namespace {

struct Bound {
  Rational t;
  bool is_closed;
};

/// An interval of t.
struct Interval {
  Bound low{0, true};
  Bound high{1, true};

  void raise(const Bound& bound) {
    const int order = cmp(bound.t, low.t);
    if (order > 0 || (order == 0 && !bound.is_closed)) low = bound;
  }
  void reduce(const Bound& bound) {
    const int order = cmp(bound.t, high.t);
    if (order < 0 || (order == 0 && !bound.is_closed)) high = bound;
  }
  bool is_empty() const {
    const int order = cmp(low.t, high.t);
    return order > 0 || (order == 0 && !(low.is_closed && high.is_closed));
  }
};

/// Leaves the t where one coordinate, from a to b, is in [low, high).
bool cut(Interval& interval, const Rational& a, const Rational& b, const Rational& low,
         const Rational& high) {
  const Rational d = b - a;
  if (sgn(d) == 0) return low <= a && a < high;
  const Bound at_low{(low - a) / d, true}, at_high{(high - a) / d, false};
  interval.raise(sgn(d) > 0 ? at_low : at_high);
  interval.reduce(sgn(d) > 0 ? at_high : at_low);
  return !interval.is_empty();
}

}  // namespace

bool meets_pixel(const Point& a, const Point& b, const Point& centre) {
  static const Rational half(1, 2);
  Interval interval;
  return cut(interval, a.x, b.x, centre.x - half, centre.x + half) &&
         cut(interval, a.y, b.y, centre.y - half, centre.y + half);
}

}  // namespace plumbline::round_steps

#include "compare/common_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::compare_steps {
namespace {

/// Gives each float vertex a number. Both lists are ascending.
PointList joined_points(const Sides& sides, std::vector<std::size_t>& number_of_float) {
  const FilteredPoints &exacts = sides.points[Exact], &floats = sides.points[Float];
  const auto order = [&](std::size_t v, std::size_t w) {
    const double x = exacts.rough(v).x, other_x = floats.rough(w).x;
    if (x != other_x) return x < other_x ? -1 : 1;
    return PointList::compare(exacts.list(), v, floats.list(), w);
  };
  PointList result = exacts.list();
  for (std::size_t v = 0, w = 0; w < floats.size(); ++w) {
    int next = 1;
    while (v < exacts.size() && (next = order(v, w)) < 0) ++v;
    const bool is_common = v < exacts.size() && next == 0;
    number_of_float.push_back(is_common ? v : result.size());
    if (!is_common) result.push_back(floats.list(), w);
  }
  return result;
}

/// Truncated to a double, and what that leaves.
long double fine(const Rational& x) {
  const double high = x.get_d();
  if (!std::isfinite(high)) return high;
  const Rational rest = x - Rational(high);
  return static_cast<long double>(high) + static_cast<long double>(rest.get_d());
}

}  // namespace

CommonPoints::CommonPoints(const Sides& sides)
    : stored_(joined_points(sides, number_of_float_)),
      made_(stored_.size()),
      filtered_(stored_),
      fine_(fine_points(stored_)) {
  long double largest = 0;
  for (const Fine& p : fine_) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  // The integers of a point and their quotient are rounded once each, each time by half an epsilon;
  // so is the sum of two doubles, of which the second one is off by much less.
  fine_error_ = 2 * std::numeric_limits<long double>::epsilon() * largest + 0x1p-1022L;
}

std::vector<CommonPoints::Fine> CommonPoints::fine_points(const PointList& points) {
  std::vector<Fine> result;
  result.reserve(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (const WidePoint* wide = points.wide(p)) {
      const auto w = static_cast<long double>(wide->w);
      result.push_back(
          {static_cast<long double>(wide->x) / w, static_cast<long double>(wide->y) / w});
    } else {
      const Point point = points[p];
      result.push_back({fine(point.x), fine(point.y)});
    }
  }
  return result;
}

const Point& CommonPoints::point(std::size_t p) const {
  if (!made_[p]) made_[p] = stored_[p];
  return *made_[p];
}

int CommonPoints::orientation(std::size_t p, std::size_t q, std::size_t r) const {
  if (p == q || q == r || p == r) return 0;
  const Fine &a = fine_[p], &b = fine_[q], &c = fine_[r];
  const long double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
  const long double left = ux * vy, right = uy * vx, det = left - right;
  // As in FilteredPoints: what differences are off by, in products, and the rounding of these.
  const long double d = 4 * fine_error_;
  const long double bound =
      2 * (d * (std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy) + 2 * d) +
           2 * std::numeric_limits<long double>::epsilon() * (std::abs(left) + std::abs(right))) +
      0x1p-1000L;
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return plumbline::orientation(point(p), point(q), point(r));
}

}  // namespace plumbline::compare_steps

#include "compare/common_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::compare_steps {
namespace {

/// Gives each float vertex a number. Both lists are ascending.
std::vector<Point> joined_points(const Sides& sides, std::vector<std::size_t>& number_of_float) {
  const FilteredPoints &exacts = sides.points[Exact], &floats = sides.points[Float];
  std::vector<Point> result(sides[Exact].vertices.begin(), sides[Exact].vertices.end());
  for (std::size_t v = 0, w = 0; w < floats.size(); ++w) {
    const PointD& q = floats.rough(w);
    while (v < exacts.size() &&
           (exacts.rough(v).x < q.x || (exacts.rough(v).x == q.x && exacts[v] < floats[w]))) {
      ++v;
    }
    const bool is_common = v < exacts.size() && exacts.rough(v).x == q.x && exacts[v] == floats[w];
    number_of_float.push_back(is_common ? v : result.size());
    if (!is_common) result.push_back(floats[w]);
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
    : points_(joined_points(sides, number_of_float_)),
      stored_(points_),
      filtered_(stored_),
      fine_(fine_points(points_)) {
  long double largest = 0;
  for (const Fine& p : fine_) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  // The sum of both parts is rounded once; the second one is off by much less.
  fine_error_ = std::numeric_limits<long double>::epsilon() * largest + 0x1p-1022L;
}

std::vector<CommonPoints::Fine> CommonPoints::fine_points(const std::vector<Point>& points) {
  std::vector<Fine> result;
  result.reserve(points.size());
  for (const Point& p : points) result.push_back({fine(p.x), fine(p.y)});
  return result;
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
  return plumbline::orientation(points_[p], points_[q], points_[r]);
}

}  // namespace plumbline::compare_steps

#include <cmath>

#include "geometry/point_d.hpp"
#include "plumbline/engines/plasm_stages.hpp"

namespace plumbline::plasm {
namespace {

PointD minus(const PointD& p, const PointD& q) { return {p.x - q.x, p.y - q.y}; }
double dot(const PointD& p, const PointD& q) { return p.x * q.x + p.y * q.y; }
/// Not a number for the vector without length.
PointD unit(const PointD& v) {
  const double inverse = 1 / std::hypot(v.x, v.y);
  return {v.x * inverse, v.y * inverse};
}

}  // namespace

Meeting meet(const SegmentD& first, const SegmentD& second, double radius) {
  const PointD u = minus(first.b, first.a);
  const PointD v = minus(second.b, second.a);
  const PointD start = minus(second.a, first.a);
  const auto is_one = [&](double cosine) {
    return 1 - radius < std::abs(cosine) && std::abs(cosine) < 1 + radius;
  };
  Meeting result;
  if (is_one(dot(unit(u), unit(v)))) {
    const bool is_on_line =
        is_one(dot(unit(u), unit(start))) || std::hypot(start.x, start.y) < radius;
    result.kind = is_on_line ? Meeting::Kind::Collinear : Meeting::Kind::Parallel;
    if (!is_on_line) return result;
    const double scale = 1 / dot(u, u);
    for (const PointD& end : {second.a, second.b}) {
      const double at = scale * dot(u, minus(end, first.a));
      if (0 < at && at < 1) result.cuts.push_back({at, end});
    }
    return result;
  }
  const double determinant = v.y * u.x - v.x * u.y;
  result.on_first = (v.x * -start.y - v.y * -start.x) / determinant;
  result.on_second = (u.x * -start.y - u.y * -start.x) / determinant;
  if (-radius < result.on_first && result.on_first < 1 + radius && -radius <= result.on_second &&
      result.on_second <= 1 + radius) {
    result.cuts.push_back({result.on_first, point_at(first, result.on_first)});
  }
  return result;
}

}  // namespace plumbline::plasm

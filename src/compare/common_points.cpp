#include "compare/common_points.hpp"

namespace plumbline::compare_steps {
namespace {

/// Gives each float vertex a number. Both lists are ascending.
std::vector<Point> joined_points(const Sides& sides, std::vector<std::size_t>& number_of_float) {
  const FilteredPoints &exacts = sides.points[Exact], &floats = sides.points[Float];
  std::vector<Point> result = sides[Exact].vertices;
  for (std::size_t v = 0, w = 0; w < floats.size(); ++w) {
    const PointD& q = floats.rough(w);
    while (v < exacts.size() &&
           (exacts.rough(v).x < q.x || (exacts.rough(v).x == q.x && exacts[v] < floats[w])))
      ++v;
    const bool is_common = v < exacts.size() && exacts.rough(v).x == q.x && exacts[v] == floats[w];
    number_of_float.push_back(is_common ? v : result.size());
    if (!is_common) result.push_back(floats[w]);
  }
  return result;
}

}  // namespace

CommonPoints::CommonPoints(const Sides& sides)
    : points_(joined_points(sides, number_of_float_)), filtered_(points_) {}

}  // namespace plumbline::compare_steps

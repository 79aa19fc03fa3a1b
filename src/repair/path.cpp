#include "repair/path.hpp"

#include <algorithm>

namespace plumbline::repair_steps {

std::vector<Line> lines_along(const std::vector<Point>& path,
                              const std::vector<SegmentId>& segments) {
  std::vector<Line> result;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point &p = path[i - 1], &q = path[i];
    if (p == q) continue;
    const bool goes_on = !result.empty() && (result.back().a == p ? q < p : p < q) &&
                         orientation(result.back().a, result.back().b, q) == 0;
    if (goes_on) {
      (result.back().a == p ? result.back().a : result.back().b) = q;
    } else {
      result.push_back({std::min(p, q), std::max(p, q), segments});
    }
  }
  return result;
}

}  // namespace plumbline::repair_steps

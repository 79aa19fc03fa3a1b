// Two lists that are sorted by x are walked along together; each point looks at the few others in a
// strip as wide as the tolerance.

#include "compare/sole_neighbours.hpp"

#include <cmath>
#include <optional>

#include "geometry/point_d.hpp"

namespace plumbline::compare_steps {
namespace {

/// A strip with more points than this is left to a search tree.
constexpr std::size_t kMostInStrip = 16;
constexpr std::size_t kNoPoint = static_cast<std::size_t>(-1);

/// Per point the only one of the others in the square of this radius around it; kNoPoint where
/// there is none, or several, or the strip is full.
std::vector<std::size_t> sole_neighbours(const FilteredPoints& points, const FilteredPoints& others,
                                         double radius) {
  std::vector<std::size_t> result(points.size(), kNoPoint);
  std::size_t first = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const PointD& at = points.rough(p);
    while (first < others.size() && others.rough(first).x < at.x - radius) ++first;
    std::size_t found = kNoPoint, count = 0;
    for (std::size_t q = first; q < others.size() && others.rough(q).x <= at.x + radius; ++q) {
      if (q - first == kMostInStrip) {
        count = 2;
        break;
      }
      if (std::abs(others.rough(q).y - at.y) > radius) continue;
      found = q;
      ++count;
    }
    if (count == 1) result[p] = found;
  }
  return result;
}

}  // namespace

double distance_slack(const FilteredPoints& points, const FilteredPoints& others) {
  // Each difference of coordinates is off by both errors and its rounding, at most a half of them.
  return 4 * (points.error() + others.error());
}

std::vector<SolePair> sole_pairs(const FilteredPoints& points, const FilteredPoints& others,
                                 double tolerance) {
  const double radius = (tolerance + distance_slack(points, others)) * (1 + 0x1p-50);
  if (!std::isfinite(radius)) return {};
  const std::vector<std::size_t> there = sole_neighbours(points, others, radius);
  const std::vector<std::size_t> here = sole_neighbours(others, points, radius);
  std::vector<SolePair> result;
  for (std::size_t p = 0; p < there.size(); ++p) {
    if (there[p] == kNoPoint || here[there[p]] != p) continue;
    result.push_back({p, there[p], distance(points.rough(p), others.rough(there[p]))});
  }
  return result;
}

}  // namespace plumbline::compare_steps

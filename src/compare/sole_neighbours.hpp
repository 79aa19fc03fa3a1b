#pragma once

#include <vector>

#include "geometry/filtered_points.hpp"

namespace plumbline::compare_steps {

/// A pair of points, one of each list, of which each is the only one of its list that can lie
/// within the tolerance of the other. `distance` is off by at most `slack` of both lists.
struct SolePair {
  std::size_t exact, other;
  double distance;
};

/// How far the distance of two rough points, one of each list, is from the exact one at most.
double distance_slack(const FilteredPoints& points, const FilteredPoints& others);

/// The pairs of points that are as good as alone with each other, whether they lie within the
/// tolerance or not. **Heuristic** in that pairs in full places can be left out. Requires: both
/// lists are ascending by (x, y). Order: ascending. Cost: O(n).
std::vector<SolePair> sole_pairs(const FilteredPoints& points, const FilteredPoints& others,
                                 double tolerance);

}  // namespace plumbline::compare_steps

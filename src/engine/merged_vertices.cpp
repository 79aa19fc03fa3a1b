#include "engine/merged_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::engine_steps {
namespace {

double distance(const PointD& p, const PointD& q) { return std::hypot(p.x - q.x, p.y - q.y); }

}  // namespace

Cluster cluster(std::vector<PointD> members, const PointD& merged) {
  constexpr std::size_t kWindow = 32;
  std::sort(members.begin(), members.end());
  Cluster result;
  result.size = members.size();
  result.merged = merged;
  result.least_distance = std::numeric_limits<double>::infinity();
  double low = merged.y, high = merged.y;
  for (std::size_t i = 0; i < members.size(); ++i) {
    low = std::min(low, members[i].y);
    high = std::max(high, members[i].y);
    for (std::size_t j = i + 1; j < std::min(members.size(), i + kWindow); ++j) {
      result.least_distance = std::min(result.least_distance, distance(members[i], members[j]));
    }
  }
  result.extent = std::hypot(members.back().x - members.front().x, high - low);
  return result;
}

void MergedVertices::add(const Cluster& merged, std::span<const SegmentId> segments) {
  for (const SegmentId s : segments) by_segment_.emplace_back(s, clusters_.size());
  clusters_.push_back(merged);
}

void MergedVertices::sort() {
  std::sort(by_segment_.begin(), by_segment_.end());
  by_segment_.erase(std::unique(by_segment_.begin(), by_segment_.end()), by_segment_.end());
}

const Cluster* MergedVertices::nearest_to(const PointD& p,
                                          std::span<const SegmentId> segments) const {
  const Cluster* result = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const SegmentId s : segments) {
    for (auto it =
             std::lower_bound(by_segment_.begin(), by_segment_.end(), std::pair(s, std::size_t{0}));
         it != by_segment_.end() && it->first == s; ++it) {
      const Cluster& candidate = clusters_[it->second];
      const double away = distance(candidate.merged, p);
      if (away >= least) continue;
      least = away;
      result = &candidate;
    }
  }
  return result;
}

}  // namespace plumbline::engine_steps

#include "check/merged_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::checking {
namespace {

double distance(const PointD& p, const PointD& q) { return std::hypot(p.x - q.x, p.y - q.y); }

}  // namespace

double Cluster::least_distance() const {
  constexpr std::size_t kWindow = 32;
  std::vector<PointD> sorted = members;
  std::sort(sorted.begin(), sorted.end());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (std::size_t j = i + 1; j < std::min(sorted.size(), i + kWindow); ++j)
      least = std::min(least, distance(sorted[i], sorted[j]));
  return least;
}

double Cluster::extent() const {
  double left = members.front().x, right = left, low = members.front().y, high = low;
  for (const PointD& p : members) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  return std::hypot(right - left, high - low);
}

double Cluster::largest_movement() const {
  double largest = 0;
  for (const PointD& p : members) largest = std::max(largest, distance(p, merged));
  return largest;
}

void MergedVertices::add(Cluster cluster, std::span<const SegmentId> segments) {
  for (const SegmentId s : segments) by_segment_.emplace_back(s, clusters_.size());
  clusters_.push_back(std::move(cluster));
}

void MergedVertices::sort() {
  std::sort(by_segment_.begin(), by_segment_.end());
  by_segment_.erase(std::unique(by_segment_.begin(), by_segment_.end()), by_segment_.end());
}

const Cluster* MergedVertices::nearest_to(const PointD& p,
                                          std::span<const SegmentId> segments) const {
  const Cluster* result = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const SegmentId s : segments)
    for (auto it =
             std::lower_bound(by_segment_.begin(), by_segment_.end(), std::pair(s, std::size_t{0}));
         it != by_segment_.end() && it->first == s; ++it) {
      const Cluster& cluster = clusters_[it->second];
      const double away = distance(cluster.merged, p);
      if (away >= least) continue;
      least = away;
      result = &cluster;
    }
  return result;
}

}  // namespace plumbline::checking

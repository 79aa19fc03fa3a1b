#pragma once

#include <optional>
#include <span>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::engine_steps {

/// Vertices that one stage merged. Lengths are **rounded**.
struct Cluster {
  std::size_t size = 0;
  PointD merged;              ///< where they went
  double least_distance = 0;  ///< of two of them; of many, of those next to each other by x
  double extent = 0;          ///< the diagonal of their box
};
Cluster cluster(std::vector<PointD> members, const PointD& merged);

/// The clusters of a stage, to ask which of them made a finding.
class MergedVertices {
 public:
  void add(const Cluster& merged, std::span<const SegmentId> segments);
  /// Call once after the last `add`.
  void sort();
  /// Of the clusters that have a vertex on one of the segments the one nearest to p.
  const Cluster* nearest_to(const PointD& p, std::span<const SegmentId> segments) const;

 private:
  std::vector<Cluster> clusters_;
  std::vector<std::pair<SegmentId, std::size_t>> by_segment_;
};

}  // namespace plumbline::engine_steps

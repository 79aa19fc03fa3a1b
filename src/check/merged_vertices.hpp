#pragma once

#include <optional>
#include <span>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::checking {

/// Vertices that one stage merged. Lengths in doubles, **rounded**.
struct Cluster {
  std::vector<PointD> members;
  PointD merged;  ///< where they went

  double least_distance() const;    ///< of two members; of many, of those next to each other by x
  double extent() const;            ///< longer side of their box
  double largest_movement() const;  ///< of a member
};

/// The clusters of a stage, to ask which of them made a finding.
class MergedVertices {
 public:
  void add(Cluster cluster, std::span<const SegmentId> segments);
  /// Call once after the last `add`.
  void sort();
  /// Of the clusters that have a vertex on one of the segments the one nearest to p.
  const Cluster* nearest_to(const PointD& p, std::span<const SegmentId> segments) const;

 private:
  std::vector<Cluster> clusters_;
  std::vector<std::pair<SegmentId, std::size_t>> by_segment_;
};

}  // namespace plumbline::checking

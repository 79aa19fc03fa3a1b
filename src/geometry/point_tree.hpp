#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// Points in a KD-tree, for the question which of them are near a place. (Which vertices are near
/// an edge, with certified bounds, is the question of `complex/vertex_tree`; which edges are near a
/// vertex, that of `diagnose/edge_tree`.) Keeps the
/// span, not the points. Requires: finite coordinates whose squares do not overflow. Cost:
/// O(n log n) to build, O(log n) a query and what it finds.
class PointTree {
 public:
  explicit PointTree(std::span<const PointD> points);
  PointTree(const PointTree&) = delete;
  PointTree& operator=(const PointTree&) = delete;
  ~PointTree();

  /// Calls visit(i) for all points i whose rounded squared distance from p is at most that of the
  /// radius, in no order.
  void for_each_near(const PointD& p, double radius,
                     const std::function<void(std::size_t)>& visit) const;
  /// The points nearest to p, at most `count`, of those that are nearer than the radius. Nearest
  /// first. **Rounded** distances decide.
  std::vector<std::size_t> nearest(const PointD& p, std::size_t count, double radius) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;  ///< none for no points
};

}  // namespace plumbline

#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/point_d.hpp"
#include "plumbline/complex.hpp"

namespace plumbline::diagnose_steps {

/// Edges in a binary tree whose nodes keep a box and a strip along one of their edges: edges that
/// are long and close together, which boxes cannot tell apart, lie side by side and have narrow
/// strips. Cost: O(n log n) to build.
class EdgeTree {
 public:
  /// Keeps a reference to the points, one for each vertex.
  EdgeTree(const std::vector<Edge>& edges, const std::vector<PointD>& points);

  /// The point of an edge that is nearest to p. **Rounded**.
  struct Foot {
    PointD foot;
    double distance;
  };
  /// Calls visit(e, foot) for the edges whose distance from p is at most `reach`, up to rounding,
  /// near ones rather first. `visit` may make `reach` less, below 0 to end.
  template <class Visit>
  void visit(const PointD& p, const double& reach, const Visit& visit) const;

 private:
  /// Between two parallel lines: the products of points with `normal` are from `low` to `high`.
  struct Strip {
    PointD normal;
    double low, high;
  };
  struct Node {
    BoxD box;
    Strip strip;
    std::uint32_t begin, end;  ///< a range of `items_`
    std::uint32_t right;       ///< the left child is the next node; 0 for a leaf
  };
  struct Item {
    PointD a, b, unit;
    double length;
    EdgeId edge;
  };
  static constexpr std::uint32_t kLeafSize = 4;

  std::uint32_t build(std::uint32_t begin, std::uint32_t end);
  /// Of the ways to halve the range the first that separates it well, else the best one.
  void halve(std::uint32_t begin, std::uint32_t end, const Node& whole);
  Node bounds(std::uint32_t begin, std::uint32_t end) const;
  static double area(const Node& node);
  /// No more than the distance of an edge of the node; 0 or more.
  static double least_distance(const Node& node, const PointD& p);
  static Foot nearest(const Item& item, const PointD& p);

  std::vector<Item> items_;
  std::vector<Node> nodes_;
};

template <class Visit>
void EdgeTree::visit(const PointD& p, const double& reach, const Visit& visit) const {
  std::vector<std::pair<double, std::uint32_t>> stack;  // least distances, nodes
  if (!nodes_.empty()) stack.emplace_back(0, 0);
  while (!stack.empty()) {
    const auto [least, at] = stack.back();
    stack.pop_back();
    if (least > reach) continue;
    const Node& node = nodes_[at];
    if (node.right != 0) {
      const double left = least_distance(nodes_[at + 1], p);
      const double right = least_distance(nodes_[node.right], p);
      stack.emplace_back(left, at + 1);
      stack.emplace_back(right, node.right);
      if (left < right) std::swap(stack.back(), *(stack.end() - 2));
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const Foot found = nearest(items_[i], p);
      if (found.distance <= reach) visit(items_[i].edge, found);
    }
  }
}

}  // namespace plumbline::diagnose_steps

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/point_d.hpp"
#include "plumbline/complex.hpp"

namespace plumbline {

/// The vertices of a complex in a KD-tree of rounded coordinates, for the question which of them
/// are near a vertex or an edge. Distances are **rounded**, with a certified bound: where vertices
/// and edges are no further apart than d, `distance` is at most `above(d)`, and the other way
/// round. Coordinates are rounded relative to a vertex of the complex, so that it does not matter
/// how far from the origin a drawing lies. Cost: O(n log n) to build.
class VertexTree {
 public:
  explicit VertexTree(const PointList& vertices);
  explicit VertexTree(const ExactComplex& complex) : VertexTree(complex.vertices) {}

  /// A number that no distance exceeds whose counterpart (rounded or exact) is d.
  double above(double d) const { return d * kRelative + margin_; }
  /// A number that no such distance falls below.
  double below(double d) const { return (d - margin_) / kRelative; }
  /// The rounded distance of v from the segment between a and b; a == b is a point.
  double distance(VertexId v, VertexId a, VertexId b) const {
    return Query(points_[a], points_[b]).distance(points_[v]);
  }
  double length(VertexId a, VertexId b) const { return distance(points_[a], points_[b]); }

  /// Calls visit(v, distance) for every vertex v whose rounded distance from the segment between
  /// the vertices a and b is at most `reach`, in an order that depends on the complex alone. The
  /// ends are visited as well. `visit` may make `reach` less.
  template <class Visit>
  void visit(VertexId a, VertexId b, const double& reach, const Visit& visitor) const {
    visit(a, b, reach, kNoLabel, visitor);
  }
  /// The same without vertices of that label (see `set_labels`).
  template <class Visit>
  void visit(VertexId a, VertexId b, const double& reach, std::uint32_t without,
             const Visit& visitor) const;

  /// The same for vertices that are no further from either end of the segment than these are from
  /// each other, ends left out; up to rounding. If `without_labels`, those with the label of an end
  /// are left out, too.
  template <class Visit>
  void visit_between(VertexId a, VertexId b, const double& reach, bool without_labels,
                     const Visit& visitor) const;

  /// Gives each vertex a label below kNoLabel.
  void set_labels(std::span<const std::uint32_t> labels);
  static constexpr std::uint32_t kNoLabel = 0xffffffffU;

 private:
  struct Node {
    BoxD box;                  ///< of its vertices
    std::uint32_t begin, end;  ///< a range of `order_`
    std::uint32_t right;       ///< the left child is the next node; 0 for a leaf
    std::uint32_t label;       ///< that all its vertices have, or kNoLabel
  };
  /// A segment that vertices are near to.
  struct Query {
    Query(const PointD& from, const PointD& to);
    double distance(const PointD& p) const;
    bool may_reach(const Node& node, double reach) const;

    PointD a, b, unit;
    double length;
  };
  static constexpr std::uint32_t kLeafSize = 8;
  static constexpr double kRelative = 1 + 64 * std::numeric_limits<double>::epsilon();

  static double distance(const PointD& p, const PointD& q) {
    const double x = q.x - p.x, y = q.y - p.y;
    return std::sqrt(x * x + y * y);
  }
  static double squared_distance_of_box(const PointD& p, const BoxD& box) {
    const double x = p.x - std::clamp(p.x, box.low.x, box.high.x);
    const double y = p.y - std::clamp(p.y, box.low.y, box.high.y);
    return x * x + y * y;
  }
  void build(std::uint32_t begin, std::uint32_t end);
  /// Calls visit(v, place in the order) for the vertices of nodes that the query may reach and
  /// is_out(node) does not leave out.
  template <class IsOut, class Visit>
  void walk(const Query& query, const double& reach, const IsOut& is_out, const Visit& visit) const;

  std::vector<PointD> points_;
  double margin_ = 0;
  std::vector<VertexId> order_;
  std::vector<PointD> ordered_;  ///< the same points in this order
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> labels_;
};

template <class IsOut, class Visit>
void VertexTree::walk(const Query& query, const double& reach, const IsOut& is_out,
                      const Visit& visit) const {
  std::vector<std::uint32_t> stack;
  if (!nodes_.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const std::uint32_t at = stack.back();
    const Node& node = nodes_[at];
    stack.pop_back();
    if (!query.may_reach(node, above(reach)) || is_out(node)) continue;
    if (node.right != 0) {
      stack.push_back(node.right);
      stack.push_back(at + 1);
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) visit(order_[i], i);
  }
}

template <class Visit>
void VertexTree::visit(VertexId a, VertexId b, const double& reach, std::uint32_t without,
                       const Visit& visitor) const {
  const Query query(points_[a], points_[b]);
  const auto is_out = [&](const Node& node) {
    return without != kNoLabel && node.label == without;
  };
  walk(query, reach, is_out, [&](VertexId v, std::uint32_t i) {
    if (without != kNoLabel && labels_[v] == without) return;
    const double distance = query.distance(ordered_[i]);
    if (distance <= reach) visitor(v, distance);
  });
}

template <class Visit>
void VertexTree::visit_between(VertexId a, VertexId b, const double& reach, bool without_labels,
                               const Visit& visitor) const {
  const Query query(points_[a], points_[b]);
  const double longest = above(above(query.length));
  const double squared = above(longest) * above(longest);
  const auto is_label_of_end = [&](std::uint32_t label) {
    return label == labels_[a] || label == labels_[b];
  };
  const auto is_out = [&](const Node& node) {
    return (without_labels && is_label_of_end(node.label)) ||
           squared_distance_of_box(query.a, node.box) > squared ||
           squared_distance_of_box(query.b, node.box) > squared;
  };
  walk(query, reach, is_out, [&](VertexId v, std::uint32_t i) {
    const PointD& p = ordered_[i];
    const double off = query.distance(p);
    if (off > reach || v == a || v == b || (without_labels && is_label_of_end(labels_[v]))) return;
    if (distance(query.a, p) > longest || distance(query.b, p) > longest) return;
    visitor(v, off);
  });
}

}  // namespace plumbline

#pragma once

#include <queue>
#include <unordered_map>
#include <vector>

#include "diagnose/line_graph.hpp"

namespace plumbline::diagnose_steps {

/// Lengths of ways along the edges from a vertex, found as far as they are asked for (Dijkstra).
/// **Rounded**.
class Ways {
 public:
  /// Keeps a reference to the graph.
  Ways(const LineGraph& graph, VertexId from) : graph_(graph) { queue_.emplace(0, from); }

  /// Whether a way no longer than this, and then the straight one, leads to a point of the edge.
  /// True where more than kMostVertices are as near: then all is one thicket.
  bool lead_to(EdgeId e, const PointD& p, double longest);

  bool is_thicket() const { return is_thicket_; }

  /// Bounds the work where very many short edges meet.
  static constexpr std::size_t kMostVertices = 200;

 private:
  void find_within(double longest);

  using Reached = std::pair<double, VertexId>;
  const LineGraph& graph_;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue_;
  std::unordered_map<std::size_t, double> lengths_;  ///< by vertex
  bool is_thicket_ = false;
};

}  // namespace plumbline::diagnose_steps

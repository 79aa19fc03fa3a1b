#include <algorithm>
#include <cmath>
#include <tuple>

#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {
namespace {

struct LeavingEdge {
  double slope;
  VertexId target;
  HalfedgeId halfedge;
  friend bool operator<(const LeavingEdge& s, const LeavingEdge& t) {
    return std::tie(s.slope, s.target, s.halfedge) < std::tie(t.slope, t.target, t.halfedge);
  }
};

}  // namespace

Lists<HalfedgeId> edge_slope_ordering(const Graph& graph) {
  std::vector<std::vector<LeavingEdge>> leaving(graph.vertices.size());
  const auto add = [&](VertexId from, VertexId to, HalfedgeId h) {
    const PointD& p = graph.vertices[from];
    const PointD& q = graph.vertices[to];
    leaving[from].push_back({std::atan2(q.y - p.y, q.x - p.x), to, h});
  };
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const auto [tail, head] = graph.edges[e];
    if (tail == head) continue;
    add(tail, head, halfedge(EdgeId(e), false));
    add(head, tail, halfedge(EdgeId(e), true));
  }
  Lists<HalfedgeId> order;
  std::vector<HalfedgeId> around;
  for (std::vector<LeavingEdge>& list : leaving) {
    std::sort(list.begin(), list.end());
    around.clear();
    for (const LeavingEdge& l : list) around.push_back(l.halfedge);
    order.push_back(around);
  }
  return order;
}

}  // namespace plumbline::lar

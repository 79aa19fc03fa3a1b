// The face walk. "Next" is a permutation of the halfedges whatever their order around the vertices,
// so every cycle closes and every halfedge is in one.

#include "geometry/union_find.hpp"
#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {
namespace {

VertexId origin(const Graph& graph, HalfedgeId h) {
  const Edge& edge = graph.edges[edge_of(h)];
  return is_reversed(h) ? edge.head : edge.tail;
}

std::vector<HalfedgeId> next_on_face(const Graph& graph, const Lists<HalfedgeId>& edge_order) {
  std::vector<HalfedgeId> next(2 * graph.edges.size());
  for (std::size_t v = 0; v < edge_order.size(); ++v) {
    const auto around = edge_order[v];
    for (std::size_t i = 0; i < around.size(); ++i) {
      const HalfedgeId clockwise = around[i == 0 ? around.size() - 1 : i - 1];
      next[twin(around[i])] = clockwise;
    }
  }
  return next;
}

}  // namespace

Lists<HalfedgeId> face_cycles(const Graph& graph, const Lists<HalfedgeId>& edge_order) {
  const std::vector<HalfedgeId> next = next_on_face(graph, edge_order);
  std::vector<bool> visited(next.size(), false);
  Lists<HalfedgeId> cycles;
  std::vector<HalfedgeId> cycle;
  for (std::size_t start = 0; start < next.size(); ++start) {
    if (!next[start].valid()) continue;  // an isolated point
    cycle.clear();
    for (HalfedgeId h(start); !visited[h]; h = next[h]) {
      visited[h] = true;
      cycle.push_back(h);
    }
    if (!cycle.empty()) cycles.push_back(cycle);
  }
  return cycles;
}

std::vector<double> cycle_areas(const Graph& graph, const Lists<HalfedgeId>& cycles) {
  std::vector<double> areas;
  for (std::size_t c = 0; c < cycles.size(); ++c) {
    const PointD& fan = graph.vertices[origin(graph, cycles[c].front())];
    double doubled = 0;
    for (HalfedgeId h : cycles[c]) {
      const PointD& p = graph.vertices[origin(graph, h)];
      const PointD& q = graph.vertices[origin(graph, twin(h))];
      doubled += (p.x - fan.x) * (q.y - fan.y) - (p.y - fan.y) * (q.x - fan.x);
    }
    areas.push_back(doubled / 2);
  }
  return areas;
}

std::vector<Exterior> exterior_cycles(const Graph& graph, const Lists<HalfedgeId>& edge_order,
                                      const Lists<HalfedgeId>& cycles) {
  std::vector<CycleId> cycle_of(2 * graph.edges.size());
  for (std::size_t c = 0; c < cycles.size(); ++c) {
    for (HalfedgeId h : cycles[c]) cycle_of[h] = CycleId(c);
  }
  UnionFind components(graph.vertices.size());
  for (const Edge& edge : graph.edges) components.unite(edge.tail, edge.head);
  std::vector<Exterior> exteriors;
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
    // All other vertices lie right of or straight above a component's least one: nothing is between
    // the last of its edges by slope and the first.
    if (components.find(v) != v || edge_order[v].empty()) continue;
    exteriors.push_back({cycle_of[edge_order[v].back()], VertexId(v)});
  }
  return exteriors;
}

}  // namespace plumbline::lar

// The boundary of a face, its cycles joined by bridges, as one closed polyline.

#include <algorithm>

#include "plumbline/chains.hpp"
#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {

std::vector<PointD> single_polyline(const FloatComplex& complex, FaceId face) {
  const auto bridges = bridge_edges(complex, face);
  // The face's edges and bridges as a graph: its walk from the outer boundary passes all of them.
  Graph graph;
  graph.vertices = complex.vertices;
  std::vector<EdgeId> edges;
  const auto add_edges = [&](CycleId c) {
    for (const HalfedgeId h : complex.cycles[c]) edges.push_back(edge_of(h));
  };
  add_edges(complex.face_outer[face]);
  for (const CycleId hole : complex.face_holes[face]) add_edges(hole);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const EdgeId e : edges) graph.edges.push_back(complex.edges[e]);
  for (const auto& [v, w] : bridges) graph.edges.push_back({v, w});
  const HalfedgeId first = complex.cycles[complex.face_outer[face]].front();
  const auto position = std::lower_bound(edges.begin(), edges.end(), edge_of(first));
  const EdgeId first_edge(static_cast<std::size_t>(position - edges.begin()));
  const HalfedgeId start = halfedge(first_edge, is_reversed(first));

  const Lists<HalfedgeId> cycles = face_cycles(graph, edge_slope_ordering(graph));
  std::vector<PointD> polyline;
  for (std::size_t c = 0; c < cycles.size(); ++c) {
    if (std::find(cycles[c].begin(), cycles[c].end(), start) == cycles[c].end()) continue;
    for (const HalfedgeId h : cycles[c]) {
      const Edge& edge = graph.edges[edge_of(h)];
      polyline.push_back(graph.vertices[is_reversed(h) ? edge.head : edge.tail]);
    }
  }
  polyline.push_back(polyline.front());
  return polyline;
}

}  // namespace plumbline::lar

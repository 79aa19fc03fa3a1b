#include <algorithm>

#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {
namespace {

/// Vertices of isolated points that no edge uses.
std::vector<VertexId> isolated_vertices(const Graph& graph) {
  std::vector<bool> on_edge(graph.vertices.size(), false);
  for (const Edge& edge : graph.edges) {
    if (edge.tail != edge.head) on_edge[edge.tail] = on_edge[edge.head] = true;
  }
  std::vector<VertexId> isolated;
  for (std::size_t v = 0; v < on_edge.size(); ++v) {
    if (!on_edge[v]) isolated.push_back(VertexId(v));
  }
  return isolated;
}

std::vector<CycleId> outer_cycles(std::size_t cycles, std::span<const Exterior> exteriors) {
  std::vector<bool> is_exterior(cycles, false);
  for (const Exterior& exterior : exteriors) is_exterior[exterior.cycle] = true;
  std::vector<CycleId> outer;
  for (std::size_t c = 0; c < cycles; ++c) {
    if (!is_exterior[c]) outer.push_back(CycleId(c));
  }
  return outer;
}

template <class T>
Lists<T> flat(const std::vector<std::vector<T>>& lists) {
  Lists<T> result;
  for (const std::vector<T>& list : lists) result.push_back(list);
  return result;
}

}  // namespace

FloatComplex cells(const Graph& graph, const Lists<HalfedgeId>& cycles,
                   std::span<const Exterior> exteriors, std::span<const double> areas) {
  FloatComplex complex;
  complex.vertices = graph.vertices;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (graph.edges[e].tail == graph.edges[e].head) break;  // isolated points come last
    complex.edges.push_back(graph.edges[e]);
    complex.edge_sources.push_back(graph.edge_sources[e]);
  }
  complex.cycles = cycles;

  const std::vector<CycleId> outer = outer_cycles(cycles.size(), exteriors);
  const std::vector<VertexId> isolated = isolated_vertices(graph);
  std::vector<VertexId> contained;
  for (const Exterior& exterior : exteriors) contained.push_back(exterior.least_vertex);
  contained.insert(contained.end(), isolated.begin(), isolated.end());
  const std::vector<CycleId> innermost = innermost_cycles(graph, cycles, areas, outer, contained);

  complex.face_outer.push_back(CycleId());  // the unbounded face
  std::vector<FaceId> face_of(cycles.size(), kUnbounded);
  for (CycleId c : outer) {
    face_of[c] = FaceId(complex.face_outer.size());
    complex.face_outer.push_back(c);
  }
  std::vector<std::vector<CycleId>> holes(complex.face_outer.size());
  std::vector<std::vector<VertexId>> points(complex.face_outer.size());
  for (std::size_t i = 0; i < contained.size(); ++i) {
    const FaceId face = innermost[i].valid() ? face_of[innermost[i]] : kUnbounded;
    if (i < exteriors.size()) {
      holes[face].push_back(exteriors[i].cycle);
    } else {
      points[face].push_back(contained[i]);
    }
  }
  complex.face_holes = flat(holes);
  complex.face_isolated_vertices = flat(points);
  return complex;
}

}  // namespace plumbline::lar

#include <algorithm>
#include <numeric>
#include <tuple>

#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {
namespace {

struct MappedEdge {
  bool is_point;
  Edge edge;
  EdgeId from;
  auto key() const { return std::tuple(is_point, edge.tail, edge.head); }
};

/// The edges over the merged vertices, sorted, isolated points last, without zero edges.
std::vector<MappedEdge> mapped_edges(const Graph& graph, std::span<const VertexId> vertex_map) {
  std::vector<MappedEdge> result;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const auto [tail, head] =
        std::minmax(vertex_map[graph.edges[e].tail], vertex_map[graph.edges[e].head]);
    const bool is_point = graph.edge_sources[e].empty();
    if (tail != head || is_point) result.push_back({is_point, {tail, head}, EdgeId(e)});
  }
  std::sort(result.begin(), result.end(), [](const MappedEdge& s, const MappedEdge& t) {
    return std::tuple(s.key(), s.from) < std::tuple(t.key(), t.from);
  });
  return result;
}

/// Drops the vertices that no edge uses.
void remove_unused_vertices(Graph& graph) {
  std::vector<VertexId> renumbered(graph.vertices.size());
  for (const Edge& edge : graph.edges) renumbered[edge.tail] = renumbered[edge.head] = VertexId(0);
  std::size_t used = 0;
  for (std::size_t v = 0; v < renumbered.size(); ++v) {
    if (!renumbered[v].valid()) continue;
    graph.vertices[used] = graph.vertices[v];
    renumbered[v] = VertexId(used++);
  }
  graph.vertices.resize(used);
  for (Edge& edge : graph.edges) edge = {renumbered[edge.tail], renumbered[edge.head]};
}

}  // namespace

Graph simplify(const Graph& graph, const Pruning& pruning) {
  Graph result;
  result.vertices = pruning.vertices;
  const std::vector<MappedEdge> edges = mapped_edges(graph, pruning.vertex_map);
  for (std::size_t i = 0; i < edges.size();) {
    const MappedEdge& first = edges[i];
    std::vector<SegmentId> sources;
    for (; i < edges.size() && edges[i].key() == first.key(); ++i) {
      const auto more = graph.edge_sources[edges[i].from];
      sources.insert(sources.end(), more.begin(), more.end());
    }
    std::sort(sources.begin(), sources.end());
    sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
    result.edges.push_back(first.edge);
    result.edge_sources.push_back(sources);
  }
  remove_unused_vertices(result);
  return result;
}

}  // namespace plumbline::lar

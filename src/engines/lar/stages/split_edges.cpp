#include <algorithm>

#include "engines/lar/stages/points.hpp"
#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {

Graph split_edges(const Graph& graph, const Lists<Cut>& cuts) {
  Graph result;
  std::vector<PointD> points = graph.vertices;
  for (const Cut& cut : cuts.flat()) points.push_back(cut.point);
  result.vertices = sorted_unique(std::move(points));

  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const VertexId tail = find_vertex(result.vertices, graph.vertices[graph.edges[e].tail]);
    const VertexId head = find_vertex(result.vertices, graph.vertices[graph.edges[e].head]);
    std::vector<VertexId> outline{tail};
    for (const Cut& cut : cuts[e]) outline.push_back(find_vertex(result.vertices, cut.point));
    outline.push_back(head);
    for (std::size_t i = 1; i < outline.size(); ++i) {
      const auto [first, last] = std::minmax(outline[i - 1], outline[i]);
      result.edges.push_back({first, last});
      result.edge_sources.push_back(graph.edge_sources[e]);
    }
  }
  return result;
}

}  // namespace plumbline::lar

#include "engines/lar/explain/cells.hpp"

#include <algorithm>

#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {

Graph graph_of(const LineWork& work) {
  std::vector<PointD> vertices = work.points;
  for (const auto& [a, b] : work.segments) vertices.insert(vertices.end(), {a, b});
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto vertex = [&](const PointD& p) {
    const auto at = std::lower_bound(vertices.begin(), vertices.end(), p);
    return VertexId(static_cast<std::size_t>(at - vertices.begin()));
  };
  Graph graph;
  for (std::size_t i = 0; i < work.segments.size(); ++i) {
    graph.edges.push_back({vertex(work.segments[i].a), vertex(work.segments[i].b)});
    graph.edge_sources.push_back(work.sources[i]);
  }
  for (const PointD& p : work.points) {
    graph.edges.push_back({vertex(p), vertex(p)});
    graph.edge_sources.push_back(std::span<const SegmentId>());
  }
  // Nothing is merged, but equal pieces become one.
  Pruning none{vertices, {}, {}};
  for (std::size_t v = 0; v < vertices.size(); ++v) none.vertex_map.emplace_back(v);
  graph.vertices = std::move(vertices);
  return simplify(graph, none);
}

namespace {

bool is_arrangement_of(const ExactComplex& complex, const Graph& graph) {
  const auto pieces = std::count_if(graph.edges.begin(), graph.edges.end(),
                                    [](const Edge& e) { return e.tail != e.head; });
  return complex.edge_count() == static_cast<std::size_t>(pieces) &&
         complex.vertices.size() == graph.vertices.size();
}

}  // namespace

ExactComplex cells_of(const LineWork& work, std::size_t threads) {
  ExactComplex arranged = plumbline::arrange(work, threads);
  const Graph graph = graph_of(work);
  if (is_arrangement_of(arranged, graph)) return arranged;
  return exact(canonical(faces(graph)));
}

bool is_plane(const LineWork& work, std::size_t threads) {
  return is_arrangement_of(plumbline::arrange(work, threads), graph_of(work));
}

}  // namespace plumbline::lar

#include "check/line_work.hpp"

#include <algorithm>
#include <array>

#include "plumbline/arrange.hpp"
#include "plumbline/lar_stages.hpp"

namespace plumbline::checking {

LineWork rounded(const SegmentSet& input) {
  LineWork result;
  for (std::size_t i = 0; i < input.segments.size(); ++i) {
    const auto numbers = input.segments.numbers(i);
    result.segments.push_back({nearest(NumberPoint{numbers[0], numbers[1]}),
                               nearest(NumberPoint{numbers[2], numbers[3]})});
    result.sources.push_back(std::array{SegmentId(i)});
  }
  for (const Point& p : input.points) result.points.push_back(nearest(p));
  return result;
}

ExactComplex arrange(const LineWork& work, std::size_t threads) {
  SegmentSet set;
  std::vector<std::size_t> piece_of;  // of each segment of the set
  for (std::size_t i = 0; i < work.segments.size(); ++i) {
    const auto& [a, b] = work.segments[i];
    if (a == b) continue;
    set.add(a, b, SourceId{});
    piece_of.push_back(i);
  }
  for (const PointD& p : work.points) set.add_point(exact(p), SourceId{});
  ExactComplex complex = plumbline::arrange(set, Engine::Bucket, {threads, {}});
  Lists<SegmentId> sources;
  std::vector<SegmentId> ids;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    ids.clear();
    for (const SegmentId piece : complex.edge_sources[e]) {
      const auto of_piece = work.sources[piece_of[piece]];
      ids.insert(ids.end(), of_piece.begin(), of_piece.end());
    }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    sources.push_back(ids);
  }
  complex.edge_sources = std::move(sources);
  return complex;
}

lar::Graph graph_of(const LineWork& work) {
  std::vector<PointD> vertices = work.points;
  for (const auto& [a, b] : work.segments) vertices.insert(vertices.end(), {a, b});
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto vertex = [&](const PointD& p) {
    const auto at = std::lower_bound(vertices.begin(), vertices.end(), p);
    return VertexId(static_cast<std::size_t>(at - vertices.begin()));
  };
  lar::Graph graph;
  for (std::size_t i = 0; i < work.segments.size(); ++i) {
    graph.edges.push_back({vertex(work.segments[i].a), vertex(work.segments[i].b)});
    graph.edge_sources.push_back(work.sources[i]);
  }
  for (const PointD& p : work.points) {
    graph.edges.push_back({vertex(p), vertex(p)});
    graph.edge_sources.push_back(std::span<const SegmentId>());
  }
  // Nothing is merged, but equal pieces become one.
  lar::Pruning none{vertices, {}, {}};
  for (std::size_t v = 0; v < vertices.size(); ++v) none.vertex_map.emplace_back(v);
  graph.vertices = std::move(vertices);
  return lar::simplify(graph, none);
}

namespace {

bool is_arrangement_of(const ExactComplex& complex, const lar::Graph& graph) {
  const auto pieces = std::count_if(graph.edges.begin(), graph.edges.end(),
                                    [](const Edge& e) { return e.tail != e.head; });
  return complex.edge_count() == static_cast<std::size_t>(pieces) &&
         complex.vertices.size() == graph.vertices.size();
}

}  // namespace

ExactComplex cells_of(const LineWork& work, std::size_t threads) {
  ExactComplex arranged = arrange(work, threads);
  const lar::Graph graph = graph_of(work);
  if (is_arrangement_of(arranged, graph)) return arranged;
  return exact(canonical(lar::faces(graph)));
}

bool is_plane(const LineWork& work, std::size_t threads) {
  return is_arrangement_of(arrange(work, threads), graph_of(work));
}

}  // namespace plumbline::checking

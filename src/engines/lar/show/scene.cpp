#include "engines/lar/show/scene.hpp"

#include <cmath>

namespace plumbline::svg {
namespace {

using Pair = std::array<VertexId, 2>;

Pair pair(const Edge& edge) { return {edge.tail, edge.head}; }

std::vector<std::vector<VertexId>> vectors(const Lists<VertexId>& lists) {
  std::vector<std::vector<VertexId>> result;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    result.emplace_back(lists[i].begin(), lists[i].end());
  }
  return result;
}

std::vector<PointD> points(std::span<const PointD> vertices, std::span<const VertexId> cycle) {
  std::vector<PointD> result;
  for (const VertexId v : cycle) result.push_back(vertices[v]);
  return result;
}

std::vector<PointD> points(const FloatComplex& complex, CycleId cycle) {
  std::vector<PointD> result;
  for (const HalfedgeId h : complex.cycles[cycle]) {
    result.push_back(complex.vertices[complex.origin(h)]);
  }
  return result;
}

/// From a trace's coordinates to the drawing's.
class Scale {
 public:
  explicit Scale(int exponent) : exponent_(exponent) {}
  PointD operator()(const PointD& p) const {
    return {std::ldexp(p.x, exponent_), std::ldexp(p.y, exponent_)};
  }
  std::vector<PointD> operator()(std::vector<PointD> list) const {
    for (PointD& p : list) p = (*this)(p);
    return list;
  }

 private:
  int exponent_;
};

}  // namespace

LarScene scene(const lar::Result& result) {
  const lar::Trace& trace = result.trace;
  const lar::Round& first = trace.rounds.front();
  const lar::Graph& graph = trace.rounds.back().simplified;
  const Scale scaled(trace.exponent);
  LarScene scene;
  for (std::size_t e = 0; e < trace.drawing.edges.size(); ++e) {
    const auto [tail, head] = trace.drawing.edges[e];
    scene.lines.push_back({scaled(trace.drawing.vertices[tail]),
                           scaled(trace.drawing.vertices[head]), first.buckets.size() + e});
  }
  for (std::size_t b = first.buckets.size(); b-- > 0;)
    for (const EdgeId e : first.buckets[b]) scene.lines[e].bucket = b;
  scene.vertices = scaled(graph.vertices);
  for (const Edge& edge : graph.edges) scene.edges.push_back(pair(edge));
  for (std::size_t c = 0; c < trace.biconnected.size(); ++c) {
    scene.components.emplace_back();
    for (const EdgeId e : trace.biconnected[c]) {
      scene.components.back().push_back(pair(graph.edges[e]));
    }
  }
  for (const EdgeId e : trace.bridges) scene.bridges.push_back(pair(graph.edges[e]));
  for (std::size_t f = 1; f < result.complex.face_count(); ++f) {
    scene.faces.push_back({points(result.complex, result.complex.face_outer[f])});
    for (const CycleId hole : result.complex.face_holes[f]) {
      scene.faces.back().push_back(points(result.complex, hole));
    }
  }
  scene.unpruned = scaled(first.split.vertices);
  scene.clusters = vectors(first.pruning.clusters);
  for (const std::vector<VertexId>& cluster : scene.clusters) {
    const VertexId merged = first.pruning.vertex_map[cluster.front()];
    scene.centroids.push_back(scaled(first.pruning.vertices[merged]));
  }
  scene.radius = trace.radius;
  return scene;
}

LarScene scene(const inters::Trace& trace) {
  LarScene scene;
  for (std::size_t i = 0; i < trace.lines.size(); ++i) {
    const bool has_partner = i < trace.buckets.size() && !trace.buckets[i].empty();
    const std::size_t least = has_partner ? std::size_t{trace.buckets[i].front()} : i;
    scene.lines.push_back({trace.lines[i].a, trace.lines[i].b, std::min(i, least)});
  }
  scene.vertices = trace.lar.vertices;
  scene.edges = trace.lar.edges;
  scene.components = trace.components;
  scene.bridges = trace.bridges;
  if (trace.lar_from_lines) {
    const inters::Model& model = *trace.lar_from_lines;
    for (std::size_t f = 0; f < model.faces.size(); ++f) {
      scene.faces.push_back({points(model.vertices, model.faces[f])});
    }
  }
  scene.unpruned = trace.raw.vertices;
  scene.clusters = vectors(trace.prune.clusters);
  for (const std::vector<VertexId>& cluster : scene.clusters) {
    scene.centroids.push_back(trace.prune.vertices[trace.prune.vertex_map[cluster.front()]]);
  }
  scene.radius = trace.options.radius;
  return scene;
}

}  // namespace plumbline::svg

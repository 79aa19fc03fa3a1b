#include "engines/lar/show/result_scene.hpp"

#include <cmath>

#include "engines/lar/show/picture.hpp"
#include "plumbline/chains.hpp"

namespace plumbline::svg {
namespace {

using Pair = std::array<VertexId, 2>;

Pair pair(const Edge& edge) { return {edge.tail, edge.head}; }

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

std::vector<std::vector<TriangleD>> fillings(const FloatComplex& float_complex) {
  const ExactComplex complex = exact(float_complex);
  std::vector<std::vector<TriangleD>> result;
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    result.push_back(filling(complex, FaceId(f)));
  }
  return result;
}

std::vector<Bridged> bridged(const FloatComplex& complex) {
  std::vector<Bridged> faces;
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    faces.push_back({{lar::single_polyline(complex, FaceId(f))}, {}});
    for (const auto& [v, w] : bridge_edges(complex, FaceId(f))) {
      faces.back().bridges.push_back({complex.vertices[v], complex.vertices[w]});
    }
  }
  return faces;
}

std::vector<EndsD> boundary(const FloatComplex& complex, std::span<const std::size_t> faces) {
  std::vector<FaceId> chain;
  for (const std::size_t f : faces) chain.emplace_back(f + 1);
  std::vector<EndsD> edges;
  for (const HalfedgeId h : boundary_chain(complex, chain)) {
    edges.push_back({complex.vertices[complex.origin(h)], complex.vertices[complex.target(h)]});
  }
  return edges;
}

}  // namespace

Scene scene(const lar::Result& result) {
  const lar::Trace& trace = result.trace;
  const lar::Round& first = trace.rounds.front();
  const lar::Graph& graph = trace.rounds.back().simplified;
  const Scale scaled(trace.exponent);
  Scene scene;
  for (std::size_t e = 0; e < trace.drawing.edges.size(); ++e) {
    const auto [tail, head] = trace.drawing.edges[e];
    scene.lines.push_back({scaled(trace.drawing.vertices[tail]),
                           scaled(trace.drawing.vertices[head]), first.buckets.size() + e});
  }
  for (std::size_t b = first.buckets.size(); b-- > 0;) {
    for (const EdgeId e : first.buckets[b]) scene.lines[e].bucket = b;
  }
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
  scene.solid_faces = scene.faces;
  scene.fillings = [&result] { return fillings(result.complex); };
  scene.bridged = [&result] { return bridged(result.complex); };
  scene.boundary = [&result](std::span<const std::size_t> chain) {
    return boundary(result.complex, chain);
  };
  return scene;
}

}  // namespace plumbline::svg

namespace plumbline {

std::string to_svg(const lar::Result& result, const LarPicture& options) {
  return svg::picture(svg::scene(result), options);
}

}  // namespace plumbline

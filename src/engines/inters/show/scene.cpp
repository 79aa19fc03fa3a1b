#include "engines/inters/show/scene.hpp"

#include <algorithm>
#include <map>

#include "engines/lar/show/picture.hpp"
#include "plumbline/engines/inters_show.hpp"

namespace plumbline::svg {
namespace {

using Polygon = Scene::Polygon;

/// The complex of a polygon: face 1, and what is around it and in its holes.
class PolygonComplex {
 public:
  explicit PolygonComplex(const Polygon& polygon) {
    for (const std::vector<PointD>& cycle : polygon) add(cycle);
    // What is in the holes does not matter, so it hangs on the unbounded face too.
    std::vector<CycleId> around, holes;
    for (std::size_t c = 0; c < polygon.size(); ++c) {
      around.emplace_back(2 * c + 1);
      if (c > 0) holes.emplace_back(2 * c);
    }
    complex_.face_outer = {CycleId(), CycleId(0)};
    for (const std::vector<CycleId>& of_face : {around, holes}) {
      complex_.face_holes.push_back(of_face);
      complex_.face_isolated_vertices.push_back(std::vector<VertexId>{});
    }
  }

  ExactComplex take() { return canonical(std::move(complex_)); }

 private:
  /// Adds the cycle, and the same walked back.
  void add(const std::vector<PointD>& cycle) {
    std::vector<HalfedgeId> walk;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const VertexId v = vertex(cycle[i]), w = vertex(cycle[(i + 1) % cycle.size()]);
      if (v != w) walk.push_back(halfedge_between(v, w));
    }
    complex_.cycles.push_back(walk);
    std::vector<HalfedgeId> back;
    for (auto h = walk.rbegin(); h != walk.rend(); ++h) back.push_back(twin(*h));
    complex_.cycles.push_back(back);
  }
  VertexId vertex(const PointD& p) {
    const auto [known, is_new] = vertices_.try_emplace(p, complex_.vertices.size());
    if (is_new) complex_.vertices.push_back({Rational(p.x), Rational(p.y)});
    return VertexId(known->second);
  }
  HalfedgeId halfedge_between(VertexId v, VertexId w) {
    const bool is_reversed = complex_.vertices[w] < complex_.vertices[v];
    const Edge edge = is_reversed ? Edge{w, v} : Edge{v, w};
    const auto [known, is_new] = edges_.try_emplace({edge.tail, edge.head}, complex_.edges.size());
    if (is_new) {
      complex_.edges.push_back(edge);
      complex_.edge_sources.push_back(std::vector<SegmentId>{});
    }
    return halfedge(EdgeId(known->second), is_reversed);
  }

  ExactComplex complex_;
  std::map<PointD, std::size_t> vertices_;
  std::map<std::pair<VertexId, VertexId>, std::size_t> edges_;
};

/// Cells of the containment lattice. Requires: there is one.
std::vector<Polygon> cells(const inters::Trace& trace) {
  std::vector<Polygon> result;
  for (const std::vector<std::size_t>& cell : *trace.cells) {
    result.emplace_back();
    for (const std::size_t cycle : cell) {
      std::vector<PointD> polyline = trace.boundary_polylines[cycle].value->front();
      polyline.pop_back();  // the first point again
      result.back().push_back(std::move(polyline));
    }
  }
  return result;
}

std::vector<std::vector<TriangleD>> fillings(std::span<const Polygon> faces) {
  std::vector<std::vector<TriangleD>> result;
  for (const Polygon& face : faces) {
    result.push_back(filling(PolygonComplex(face).take(), FaceId(1)));
  }
  return result;
}

std::vector<Bridged> bridged(const inters::Trace& trace, std::span<const Polygon> polygons) {
  std::vector<Bridged> faces;
  for (const Polygon& polygon : polygons) faces.push_back({polygon, {}});
  if (!trace.bridge_edges) return faces;
  for (std::size_t c = 0; c < faces.size(); ++c) {
    for (const auto& [v, w] : (*trace.bridge_edges)[c]) {
      faces[c].bridges.push_back({trace.lar.vertices[v], trace.lar.vertices[w]});
    }
  }
  return faces;
}

/// What has the solid faces: the cells where the lattice gives them.
const inters::Model* model_of(const inters::Trace& trace) {
  if (trace.two_complex) return &*trace.two_complex;
  return trace.lar_from_lines ? &*trace.lar_from_lines : nullptr;
}

std::vector<EndsD> boundary(const inters::Trace& trace, std::span<const std::size_t> faces) {
  const inters::Model* const model = model_of(trace);
  std::vector<EndsD> edges;
  if (!model) return edges;
  for (const std::size_t e : inters::boundary_chain(*model, faces)) {
    const auto& [v, w] = model->edges[e];
    edges.push_back({model->vertices[v], model->vertices[w]});
  }
  return edges;
}

}  // namespace

Scene scene(const inters::Trace& trace) {
  Scene scene;
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
  scene.solid_faces = trace.two_complex ? cells(trace) : scene.faces;
  scene.fillings = [faces = scene.solid_faces] { return fillings(faces); };
  scene.bridged = [&trace, faces = scene.solid_faces] { return bridged(trace, faces); };
  scene.boundary = [&trace](std::span<const std::size_t> chain) { return boundary(trace, chain); };
  return scene;
}

}  // namespace plumbline::svg

namespace plumbline {

std::string to_svg(const inters::Trace& trace, const LarPicture& options) {
  return svg::picture(svg::scene(trace), options);
}

}  // namespace plumbline

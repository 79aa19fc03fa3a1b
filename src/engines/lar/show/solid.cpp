#include "engines/lar/show/solid.hpp"

#include <map>
#include <string>

#include "plumbline/chains.hpp"
#include "plumbline/error.hpp"
#include "plumbline/triangulate.hpp"

namespace plumbline::svg {
namespace {

using inters::Model;
using Polygon = LarScene::Polygon;
using PointPair = std::array<PointD, 2>;

void check(std::span<const std::size_t> faces, std::size_t count) {
  for (const std::size_t f : faces) {
    if (f < count) continue;
    throw Error(ErrorCode::BadInput,
                "no such face; they are numbered from 0 to the last of " + std::to_string(count),
                {}, std::to_string(f));
  }
}

std::vector<TriangleD> filling(const ExactComplex& complex, FaceId face) {
  std::vector<TriangleD> result;
  try {
    for (const auto& [p, q, r] : triangulate(complex, face)) {
      result.push_back({nearest(complex.vertices[p]), nearest(complex.vertices[q]),
                        nearest(complex.vertices[r])});
    }
  } catch (const Error& error) {
    if (error.code() != ErrorCode::BadInput) throw;  // the float complex is not valid here
  }
  return result;
}

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

/// What the published variant shows: cells where the lattice gives them.
const Model* published_model(const inters::Trace& trace) {
  if (trace.two_complex) return &*trace.two_complex;
  return trace.lar_from_lines ? &*trace.lar_from_lines : nullptr;
}

}  // namespace

std::vector<Polygon> solid_faces(const lar::Result& result) { return scene(result).faces; }

std::vector<Polygon> solid_faces(const inters::Trace& trace) {
  if (!trace.two_complex) return scene(trace).faces;
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

std::vector<std::vector<TriangleD>> fillings(const lar::Result& result) {
  const ExactComplex complex = exact(result.complex);
  std::vector<std::vector<TriangleD>> fillings;
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    fillings.push_back(filling(complex, FaceId(f)));
  }
  return fillings;
}

std::vector<std::vector<TriangleD>> fillings(const inters::Trace& trace) {
  std::vector<std::vector<TriangleD>> fillings;
  for (const Polygon& face : solid_faces(trace)) {
    fillings.push_back(filling(PolygonComplex(face).take(), FaceId(1)));
  }
  return fillings;
}

std::vector<Bridged> bridged(const lar::Result& result) {
  const FloatComplex& complex = result.complex;
  std::vector<Bridged> faces;
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    faces.push_back({{lar::single_polyline(complex, FaceId(f))}, {}});
    for (const auto& [v, w] : bridge_edges(complex, FaceId(f))) {
      faces.back().bridges.push_back({complex.vertices[v], complex.vertices[w]});
    }
  }
  return faces;
}

std::vector<Bridged> bridged(const inters::Trace& trace) {
  std::vector<Bridged> faces;
  for (Polygon& polygon : solid_faces(trace)) faces.push_back({std::move(polygon), {}});
  if (!trace.bridge_edges) return faces;
  for (std::size_t c = 0; c < faces.size(); ++c) {
    for (const auto& [v, w] : (*trace.bridge_edges)[c]) {
      faces[c].bridges.push_back({trace.lar.vertices[v], trace.lar.vertices[w]});
    }
  }
  return faces;
}

std::vector<PointPair> boundary(const lar::Result& result, std::span<const std::size_t> faces) {
  const FloatComplex& complex = result.complex;
  check(faces, complex.face_count() - 1);
  std::vector<FaceId> chain;
  for (const std::size_t f : faces) chain.emplace_back(f + 1);
  std::vector<PointPair> edges;
  for (const HalfedgeId h : boundary_chain(complex, chain)) {
    edges.push_back({complex.vertices[complex.origin(h)], complex.vertices[complex.target(h)]});
  }
  return edges;
}

std::vector<PointPair> boundary(const inters::Trace& trace, std::span<const std::size_t> faces) {
  const Model* const model = published_model(trace);
  check(faces, model ? model->faces.size() : 0);
  std::vector<PointPair> edges;
  if (!model) return edges;
  for (const std::size_t e : inters::boundary_chain(*model, faces)) {
    const auto& [v, w] = model->edges[e];
    edges.push_back({model->vertices[v], model->vertices[w]});
  }
  return edges;
}

}  // namespace plumbline::svg

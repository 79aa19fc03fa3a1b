// The signature of a complex in one piece.

#include <vector>

#include "tiles/cell_hash.hpp"

namespace plumbline::tiles {

CellHash signature2(const ExactComplex& complex) {
  CellHash sum;
  std::vector<CellHash> of_vertex(complex.vertices.size());
  for (std::size_t v = 0; v < of_vertex.size(); ++v) {
    of_vertex[v] = vertex_hash(complex.vertices, v);
    sum += of_vertex[v];
  }
  for (const Edge& e : complex.edges) sum += edge_hash(of_vertex[e.tail], of_vertex[e.head]);
  std::vector<CellHash> of_face(complex.face_count());
  for (std::size_t c = 0; c < complex.cycles.size(); ++c) {
    const auto cycle = complex.cycles[c];
    CellHash halfedges;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const HalfedgeId h = cycle[i], next = cycle[i + 1 == cycle.size() ? 0 : i + 1];
      const CellHash &origin = of_vertex[complex.origin(h)], &target = of_vertex[complex.target(h)];
      halfedges += halfedge_hash(origin, target);
      sum += corner_hash(origin, target, of_vertex[complex.target(next)]);
    }
    of_face[complex.cycle_face[c]] += cycle_hash(halfedges);
  }
  for (std::size_t f = 0; f < of_face.size(); ++f) {
    for (const VertexId v : complex.face_isolated_vertices[f]) {
      of_face[f] += isolated_hash(of_vertex[v]);
    }
    sum += face_hash(of_face[f], FaceId(f) != kUnbounded);
  }
  return sum;
}

}  // namespace plumbline::tiles

#include "complex/scan_line.hpp"

namespace plumbline {

FaceId locate(const ExactComplex& complex, const Point& p) {
  const ScanLine line(complex, p.x);
  std::optional<EdgeId> highest_below;
  for (std::size_t i = 0; i < complex.edge_count(); ++i) {
    const EdgeId e(i);
    const Edge& edge = complex.edges[e];
    const Point &tail = complex.vertices[edge.tail], &head = complex.vertices[edge.head];
    if (p.x < tail.x || head.x < p.x) continue;
    if (on_segment(tail, head, p)) return complex.halfedge_face[halfedge(e, false)];
    if (!line.meets(e) || !line.passes_below(e, p)) continue;
    if (!highest_below || line.above(e, *highest_below)) highest_below = e;
  }
  return face_above(complex, highest_below);
}

}  // namespace plumbline

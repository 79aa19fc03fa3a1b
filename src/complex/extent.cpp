#include "plumbline/complex.hpp"

namespace plumbline {
namespace {

template <class PointAt>
Extent extent(const Incidences& complex, PointAt point) {
  std::vector<SegmentD> segments;
  segments.reserve(complex.edge_count());
  for (const Edge& edge : complex.edges) {
    segments.push_back({point(edge.tail), point(edge.head)});
  }
  for (std::size_t f = 0; f < complex.face_isolated_vertices.size(); ++f) {
    for (const VertexId v : complex.face_isolated_vertices[f]) {
      segments.push_back({point(v), point(v)});
    }
  }
  return plumbline::extent(segments);
}

}  // namespace

Extent extent(const ExactComplex& complex) {
  return extent(complex, [&](VertexId v) { return complex.vertices.nearest(v); });
}

Extent extent(const FloatComplex& complex) {
  return extent(complex, [&](VertexId v) { return complex.vertices[v]; });
}

}  // namespace plumbline

// What lies along the boundaries of faces.

#include <algorithm>
#include <cmath>

#include "plumbline/polygons.hpp"

namespace plumbline {
namespace {

double length(const ExactComplex& complex, const Edge& edge) {
  const PointD p = complex.vertices.nearest(edge.tail), q = complex.vertices.nearest(edge.head);
  return std::hypot(q.x - p.x, q.y - p.y);
}

}  // namespace

std::vector<std::vector<Neighbour>> neighbours(const ExactComplex& complex) {
  std::vector<std::vector<Neighbour>> result(complex.face_count());
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    if (complex.is_antenna(EdgeId(e))) continue;
    const FaceId left = complex.halfedge_face[halfedge(EdgeId(e), false)];
    const FaceId right = complex.halfedge_face[halfedge(EdgeId(e), true)];
    const double shared = length(complex, complex.edges[e]);
    result[left].push_back({right, shared});
    result[right].push_back({left, shared});
  }
  for (std::vector<Neighbour>& list : result) {
    std::stable_sort(list.begin(), list.end(),
                     [](const Neighbour& a, const Neighbour& b) { return a.face < b.face; });
    std::vector<Neighbour> joined;
    for (const Neighbour& next : list) {
      if (!joined.empty() && joined.back().face == next.face) {
        joined.back().length += next.length;
      } else {
        joined.push_back(next);
      }
    }
    list = std::move(joined);
  }
  return result;
}

std::vector<std::vector<SegmentId>> face_sources(const Incidences& complex) {
  std::vector<std::vector<SegmentId>> result(complex.face_count());
  for (std::size_t h = 0; h < complex.halfedge_face.size(); ++h) {
    const FaceId face = complex.halfedge_face[h];
    const auto sources = complex.edge_sources[edge_of(HalfedgeId(h))];
    result[face].insert(result[face].end(), sources.begin(), sources.end());
  }
  for (std::vector<SegmentId>& list : result) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return result;
}

std::vector<double> perimeters(const ExactComplex& complex) {
  std::vector<double> result(complex.face_count());
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    if (complex.is_antenna(EdgeId(e))) continue;
    const double once = length(complex, complex.edges[e]);
    for (const bool reversed : {false, true}) {
      result[complex.halfedge_face[halfedge(EdgeId(e), reversed)]] += once;
    }
  }
  return result;
}

}  // namespace plumbline

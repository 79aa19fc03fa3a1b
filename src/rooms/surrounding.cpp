#include <algorithm>
#include <utility>

#include "geometry/union_find.hpp"
#include "rooms/steps.hpp"

namespace plumbline::rooms_steps {
namespace {

/// Per edge the face that it bounds as a side of a hole; invalid for other edges.
std::vector<FaceId> faces_around_holes(const ExactComplex& complex,
                                       const std::vector<FacePolygon>& shapes) {
  std::vector<FaceId> result(complex.edge_count());
  for (const FacePolygon& polygon : shapes) {
    for (std::size_t hole = 0; hole < polygon.holes.size(); ++hole) {
      const auto ring = polygon.holes[hole];
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::pair ends = std::minmax({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
        const auto edge = std::lower_bound(
            complex.edges.begin(), complex.edges.end(), ends,
            [](const Edge& e, const auto& sought) { return std::pair(e.tail, e.head) < sought; });
        result[static_cast<std::size_t>(edge - complex.edges.begin())] = polygon.face;
      }
    }
  }
  return result;
}

}  // namespace

// Faces between which one goes without passing a side of a hole lie in the same holes.
std::vector<FaceId> surrounding_faces(const ExactComplex& complex,
                                      const std::vector<FacePolygon>& shapes) {
  const std::vector<FaceId> around = faces_around_holes(complex, shapes);
  const auto face_of = [&](std::size_t e, bool reversed) {
    return complex.halfedge_face[halfedge(EdgeId(e), reversed)];
  };
  UnionFind together(complex.face_count());
  for (std::size_t e = 0; e < around.size(); ++e) {
    if (!around[e].valid()) together.unite(face_of(e, false), face_of(e, true));
  }
  std::vector<FaceId> of_set(complex.face_count(), kUnbounded);
  for (std::size_t e = 0; e < around.size(); ++e) {
    if (!around[e].valid()) continue;
    const FaceId inside = face_of(e, face_of(e, false) == around[e]);
    of_set[together.find(inside)] = around[e];
  }
  std::vector<FaceId> result;
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    result.push_back(of_set[together.find(f)]);
  }
  return result;
}

}  // namespace plumbline::rooms_steps

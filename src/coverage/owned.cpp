// The polygons of a coverage, from the faces that they own.

#include <algorithm>
#include <utility>

#include "coverage/steps.hpp"

namespace plumbline {
namespace {

/// Of one that has faces in common with others: its own faces joined.
std::vector<FacePolygon> joined_polygons(const ExactComplex& complex, const FaceSet& faces) {
  const std::vector<std::uint32_t> classes(faces.begin(), faces.end());
  const JoinedComplex made = joined(complex, classes);
  std::vector<FaceId> origin(made.complex.face_count());
  for (std::size_t f = faces.size(); f-- > 0;) origin[made.face_of[f]] = FaceId(f);
  const auto original = [&](std::span<const VertexId> ring) {
    std::vector<VertexId> result;
    for (const VertexId v : ring) result.push_back(made.vertex_from[v]);
    return result;
  };
  std::vector<FacePolygon> result;
  for (const FacePolygon& polygon : polygons(made.complex)) {
    if (!faces[origin[polygon.face]]) continue;
    FacePolygon& added = result.emplace_back();
    added.face = origin[polygon.face];
    added.outer = original(polygon.outer);
    for (std::size_t h = 0; h < polygon.holes.size(); ++h) {
      added.holes.push_back(original(polygon.holes[h]));
    }
  }
  return result;
}

}  // namespace

std::vector<std::vector<FacePolygon>> owned_polygons(const ExactComplex& complex,
                                                     const Lists<RegionId>& owners,
                                                     std::size_t polygon_count) {
  std::vector<std::vector<FacePolygon>> result(polygon_count);
  std::vector<bool> shares(polygon_count);
  for (std::size_t f = 0; f < owners.size(); ++f) {
    if (owners[f].size() < 2) continue;
    for (const RegionId r : owners[f]) shares[r] = true;
  }
  for (FacePolygon& polygon : polygons(complex)) {
    const auto of = owners[polygon.face];
    if (of.size() == 1 && !shares[of[0]]) result[of[0]].push_back(std::move(polygon));
  }
  for (std::size_t r = 0; r < polygon_count; ++r) {
    if (!shares[r]) continue;
    FaceSet faces(owners.size());
    for (std::size_t f = 0; f < owners.size(); ++f) {
      faces[f] = std::binary_search(owners[f].begin(), owners[f].end(), RegionId(r));
    }
    result[r] = joined_polygons(complex, faces);
  }
  return result;
}

}  // namespace plumbline

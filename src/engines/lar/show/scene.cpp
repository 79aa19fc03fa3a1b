#include "engines/lar/show/scene.hpp"

#include "plumbline/chains/triangulate.hpp"
#include "plumbline/error.hpp"

namespace plumbline::svg {

std::vector<PointD> points(std::span<const PointD> vertices, std::span<const VertexId> cycle) {
  std::vector<PointD> result;
  for (const VertexId v : cycle) result.push_back(vertices[v]);
  return result;
}

std::vector<std::vector<VertexId>> vectors(const Lists<VertexId>& lists) {
  std::vector<std::vector<VertexId>> result;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    result.emplace_back(lists[i].begin(), lists[i].end());
  }
  return result;
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

}  // namespace plumbline::svg

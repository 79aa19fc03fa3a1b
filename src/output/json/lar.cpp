// A complex as a LAR model.

#include "output/json/writer.hpp"
#include "plumbline/output.hpp"
#include "plumbline/polygons.hpp"

namespace plumbline {
namespace json {
namespace {

auto exact_place(const PointList& points, std::size_t v) {
  const Point p = points[v];
  return std::tuple(decimal(p.x), decimal(p.y));
}

/// All vertices of the rings, ring after ring.
std::vector<VertexId> cell(const FacePolygon& face) {
  std::vector<VertexId> vertices = face.outer;
  const auto holes = face.holes.flat();
  vertices.insert(vertices.end(), holes.begin(), holes.end());
  return vertices;
}

auto ring_list(const FacePolygon& face) {
  return list(1 + face.holes.size(), [&face](std::size_t i) {
    return i == 0 ? std::span<const VertexId>(face.outer) : face.holes[i - 1];
  });
}

}  // namespace
}  // namespace json

std::string to_lar_json(const ExactComplex& complex) {
  using namespace json;
  const std::vector<FacePolygon> faces = polygons(complex);
  const bool have_holes =
      std::ranges::any_of(faces, [](const FacePolygon& face) { return face.holes.size() > 0; });
  const auto place = [&complex](std::size_t v) { return exact_place(complex.vertices, v); };
  const auto pair = [](const Edge& edge) { return std::tuple(edge.tail, edge.head); };
  return document(
      object(member("V", rows(Numbers(0, complex.vertices.size()), place)),
             member("FV", rows(faces, cell)), member("EV", rows(complex.edges, pair)),
             when(have_holes, [&] { return member("polygons", rows(faces, ring_list)); })),
      Layout::Dense);
}

}  // namespace plumbline

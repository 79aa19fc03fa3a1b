// Cells over merged vertices, section 2.9 (larSimplify).

#include <algorithm>
#include <cmath>
#include <string>

#include "engines/inters/stages/fail.hpp"
#include "engines/inters/stages/hash_order.hpp"
#include "engines/lar/stages/check_model.hpp"
#include "engines/lar/stages/points.hpp"
#include "plumbline/engines/inters_stages.hpp"
#include "plumbline/error.hpp"

namespace plumbline::inters {
namespace {

/// Within this the original's rank computation takes a cell for flat.
constexpr double kFlat = 1e-6;

VertexPair sorted(const VertexPair& pair) {
  return {std::min(pair[0], pair[1]), std::max(pair[0], pair[1])};
}

/// As the original computes it, which `hypot` may round differently.
double original_distance(const PointD& p, const PointD& q) {
  return std::sqrt(squared_distance(p, q));
}

/// The dimension of what the points span.
std::size_t dimension(std::span<const PointD> vertices, std::span<const VertexId> cell) {
  const PointD& origin = vertices[cell[0]];
  PointD far = origin;
  for (const VertexId v : cell) {
    if (original_distance(origin, vertices[v]) > original_distance(origin, far)) far = vertices[v];
  }
  const double length = original_distance(origin, far);
  if (length <= kFlat) return 0;
  for (const VertexId v : cell) {
    const PointD& p = vertices[v];
    const double area =
        (far.x - origin.x) * (p.y - origin.y) - (far.y - origin.y) * (p.x - origin.x);
    if (std::abs(area) > kFlat * length) return 2;
  }
  return 1;
}

Lists<VertexId> simplified_faces(const Model& raw, const Pruned& pruned) {
  const std::size_t least = dimension(raw.vertices, raw.faces[0]) + 1;
  HashTable<std::vector<VertexId>> cells;
  for (std::size_t f = 0; f < raw.faces.size(); ++f) {
    std::vector<VertexId> cell;
    for (const VertexId v : raw.faces[f]) cell.push_back(pruned.vertex_map[v]);
    std::sort(cell.begin(), cell.end());
    cell.erase(std::unique(cell.begin(), cell.end()), cell.end());
    if (cell.size() >= least) cells.insert(cell);
  }
  std::vector<std::vector<VertexId>> listed = cells.listed();
  std::stable_sort(listed.begin(), listed.end(),
                   [](const auto& s, const auto& t) { return s.size() < t.size(); });
  Lists<VertexId> faces;
  for (const std::vector<VertexId>& cell : listed) faces.push_back(cell);
  return faces;
}

/// Edges of at least so many vertices, each once.
std::vector<VertexPair> simplified_edges(const Model& raw, const Pruned& pruned,
                                         std::size_t least) {
  HashTable<Cell> cells;
  for (const VertexPair& edge : raw.edges) {
    const VertexPair mapped = sorted({pruned.vertex_map[edge[0]], pruned.vertex_map[edge[1]]});
    const std::size_t distinct = mapped[0] == mapped[1] ? 1 : 2;
    if (distinct >= least) cells.insert({mapped});
  }
  std::vector<VertexPair> edges;
  for (const Cell& cell : cells.listed()) edges.push_back(cell.vertices);
  return edges;
}

}  // namespace

Model simplify(const Model& raw, const Pruned& pruned) {
  Model result{pruned.vertices, {}, {}};
  if (raw.edges.empty()) return result;
  result.edges = simplified_edges(raw, pruned, dimension(raw.vertices, raw.edges.front()) + 1);
  std::stable_partition(result.edges.begin(), result.edges.end(),
                        [](const VertexPair& edge) { return edge[0] == edge[1]; });
  return result;
}

Model simplify(const Model& model, double radius) {
  check_cells(model);
  check_radius(radius);
  if (model.edges.empty()) {
    throw Error(ErrorCode::BadInput, "the published simplification needs an edge");
  }
  const Pruned pruned = prune_vertices(model.vertices, radius);
  if (model.faces.size() == 0) return simplify(model, pruned);
  // What the original compares with the dimension is the number of vertices, one more than that.
  return {pruned.vertices,
          simplified_edges(model, pruned, dimension(model.vertices, model.edges.front())),
          simplified_faces(model, pruned)};
}

}  // namespace plumbline::inters

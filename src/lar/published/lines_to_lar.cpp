// From fragments to a simplified 1-complex, sections 2.3 and 2.9 (lines2lar, larSimplify).

#include <algorithm>
#include <cmath>
#include <string>

#include "lar/points.hpp"
#include "lar/published/hash_order.hpp"
#include "lar/published/stages.hpp"

namespace plumbline::lar::published {
namespace {

/// Below this length the original's rank computation takes an edge for a point.
constexpr double kLeastLength = 1e-6;

PointD point_at(const SegmentD& s, double parameter) {
  return {s.a.x + parameter * (s.b.x - s.a.x), s.a.y + parameter * (s.b.y - s.a.y)};
}

/// Both ends and the points at the parameters between, in this order.
std::vector<PointD> outline(const Fragment& fragment) {
  std::vector<PointD> points{fragment.segment.a};
  for (const double parameter : fragment.parameters) {
    if (parameter != 0 && parameter != 1) points.push_back(point_at(fragment.segment, parameter));
  }
  points.push_back(fragment.segment.b);
  return points;
}

VertexPair sorted(const VertexPair& pair) {
  return {std::min(pair[0], pair[1]), std::max(pair[0], pair[1])};
}

}  // namespace

Split split(std::span<const Fragment> fragments, const Vcode& vcode) {
  Split result;
  HashTable<std::string> keys;
  HashTable<VertexPair> edges;
  for (const Fragment& fragment : fragments) {
    std::vector<VertexId> vertices;
    for (const PointD& p : outline(fragment)) {
      const auto [vertex, is_new] = keys.insert(vcode.text(p));
      if (is_new) result.model.vertices.push_back(vcode.quantised(p));
      vertices.emplace_back(vertex);
    }
    for (std::size_t i = 1; i < vertices.size(); ++i) edges.insert({vertices[i - 1], vertices[i]});
    // The original emits the pieces found so far after every vertex.
    result.edge_count_with_duplicates += vertices.size() * (vertices.size() - 1) / 2;
  }
  result.model.edges = edges.keys();
  return result;
}

Model simplify(const Model& raw, const Pruned& pruned) {
  const auto length = [&](const VertexPair& edge) {
    return std::sqrt(squared_distance(raw.vertices[edge[0]], raw.vertices[edge[1]]));
  };
  const bool keeps_points = !raw.edges.empty() && length(raw.edges.front()) <= kLeastLength;
  HashTable<Cell> cells;
  for (const VertexPair& edge : raw.edges) {
    const VertexPair mapped = sorted({pruned.vertex_map[edge[0]], pruned.vertex_map[edge[1]]});
    if (keeps_points || mapped[0] != mapped[1]) cells.insert({mapped});
  }
  Model result{pruned.vertices, {}, {}};
  for (const Cell& cell : cells.listed()) result.edges.push_back(cell.vertices);
  std::stable_partition(result.edges.begin(), result.edges.end(),
                        [](const VertexPair& edge) { return edge[0] == edge[1]; });
  return result;
}

}  // namespace plumbline::lar::published

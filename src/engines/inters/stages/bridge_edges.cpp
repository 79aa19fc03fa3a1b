// Bridge edges between the cycles of a cell, section 2.7 (scan, connectTheDots).

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engines/inters/stages/cycle_vertices.hpp"
#include "plumbline/engines/inters_stages.hpp"

namespace plumbline::inters {
namespace {

/// A vertex of a cell.
struct Item {
  PointD point;
  std::size_t cycle;  ///< of the cell
  VertexId vertex;

  friend bool operator<(const Item& s, const Item& t) {
    if (s.point != t.point) return s.point < t.point;
    return std::tie(s.cycle, s.vertex) < std::tie(t.cycle, t.vertex);
  }
};

float float_distance(const PointD& p, const PointD& q) {
  const auto dx = static_cast<float>(p.x - q.x), dy = static_cast<float>(p.y - q.y);
  const float x = dx * dx, y = dy * dy;
  return std::sqrt(x + y);
}

/// The nearest pair of vertices of two cycles; the given one unless another is nearer.
VertexPair nearest_pair(std::span<const PointD> vertices, std::span<const VertexId> cycle,
                        std::span<const VertexId> next_cycle, VertexPair pair) {
  float least = float_distance(vertices[pair[0]], vertices[pair[1]]);
  for (const VertexId i : cycle) {
    for (const VertexId j : next_cycle) {
      const float d = float_distance(vertices[i], vertices[j]);
      if (d >= least) continue;
      least = d;
      pair = {i, j};
    }
  }
  return pair;
}

std::vector<VertexPair> scan(std::span<const PointD> vertices,
                             const std::vector<std::vector<VertexId>>& cycles) {
  std::vector<Item> items;
  for (std::size_t c = 0; c < cycles.size(); ++c) {
    for (const VertexId v : cycles[c]) items.push_back({vertices[v], c, v});
  }
  std::sort(items.begin(), items.end());
  std::vector<VertexPair> bridges;
  std::vector<bool> scanned(cycles.size(), false);
  for (std::size_t k = 0; k + 2 < items.size(); ++k) {
    const std::size_t cycle = items[k].cycle, next = items[k + 1].cycle;
    if (next == cycle || (scanned[next] && scanned[cycle])) continue;
    scanned[next] = true;
    bridges.push_back(nearest_pair(vertices, cycles[cycle], cycles[next],
                                   {items[k].vertex, items[k + 1].vertex}));
  }
  if (!bridges.empty()) bridges.pop_back();
  return bridges;
}

}  // namespace

std::vector<std::vector<VertexPair>> bridge_edges(
    std::span<const PointD> vertices, std::span<const std::vector<VertexPair>> components,
    const CycleCells& cells) {
  std::vector<std::vector<VertexPair>> result;
  for (const std::vector<std::size_t>& cell : cells) {
    std::vector<std::vector<VertexId>> cycles;
    for (const std::size_t cycle : cell) cycles.push_back(cycle_vertices(components[cycle]));
    result.push_back(scan(vertices, cycles));
  }
  return result;
}

}  // namespace plumbline::inters

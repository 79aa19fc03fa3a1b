// Point in polygon by tile codes, section 2.10, and the containment lattice, section 2.6.

#include <algorithm>
#include <numeric>

#include "engines/lar/stages/tile_code.hpp"
#include "plumbline/engines/inters_stages.hpp"

namespace plumbline::inters {
namespace {

using lar::Crossing;
using lar::kAbove;
using lar::kBelow;
using lar::kHere;
using lar::kLeft;
using lar::kRight;
using lar::tile_code;

/// What one edge does to the count, in the original's order of cases. The half crossings of an edge
/// that ends on the half-line change nothing: the original counts them in copies of its counters.
/// Its `c_edge == 14 and A or B` holds for every edge whose second end is straight to the right.
Crossing cross_half_line(const PointD& from, const PointD& p, const PointD& q) {
  const unsigned c1 = tile_code(from, p), c2 = tile_code(from, q);
  const unsigned difference = c1 ^ c2, either = c1 | c2, both = c1 & c2;
  const bool has_end_here = c1 == kHere || c2 == kHere;
  const auto on = [](bool holds) { return holds ? Crossing::OnPoint : Crossing::None; };
  if (difference == 0 && either == 0) return Crossing::OnPoint;
  if (difference == (kRight | kLeft) && either == difference) return Crossing::OnPoint;
  if (difference == (kAbove | kBelow)) {
    return both == 0 ? Crossing::OnPoint : both == kRight ? Crossing::Odd : Crossing::None;
  }
  if (difference == (kAbove | kBelow | kRight | kLeft)) {
    const double x = ((from.y - q.y) * (p.x - q.x) / (p.y - q.y)) + q.x;
    return x > from.x ? Crossing::Odd : on(x == from.x);
  }
  if (difference == (kAbove | kRight | kLeft) && (c1 == kRight || c2 == kRight)) {
    return Crossing::None;
  }
  if ((difference == (kBelow | kRight | kLeft) && c1 == kRight) || c2 == kRight) {
    return Crossing::None;
  }
  if (difference == (kAbove | kBelow | kRight)) return Crossing::Odd;
  if (difference == kAbove || difference == kBelow) return on(both == 0);
  if (difference == kRight || difference == kLeft) return on(either == difference);
  if (difference == (kAbove | kRight) || difference == (kBelow | kRight) ||
      difference == (kAbove | kLeft) || difference == (kBelow | kLeft)) {
    return on(has_end_here);
  }
  return Crossing::None;
}

}  // namespace

Classification classify(std::span<const Polyline> polygon, const PointD& point) {
  bool inside = false;
  for (const Polyline& polyline : polygon) {
    for (std::size_t i = 1; i < polyline.size(); ++i) {
      const Crossing crossing = cross_half_line(point, polyline[i - 1], polyline[i]);
      if (crossing == Crossing::OnPoint) return Classification::On;
      if (crossing == Crossing::Odd) inside = !inside;
    }
  }
  return inside ? Classification::In : Classification::Out;
}

LatticeArray lattice_array(std::span<const PointD> vertices,
                           std::span<const std::vector<VertexPair>> cycles, const Vcode& vcode) {
  LatticeArray result;
  for (const std::vector<VertexPair>& cycle : cycles) {
    const std::vector<Polyline> polygon = boundary_polylines(vertices, cycle, vcode);
    std::vector<int> row;
    for (const std::vector<VertexPair>& other : cycles) {
      const Classification where = classify(polygon, vertices[other[0][0]]);
      row.push_back(where == Classification::In ? 1 : where == Classification::On ? -1 : 0);
    }
    result.push_back(std::move(row));
  }
  return result;
}

CycleCells cells_from_cycles(const LatticeArray& lattice) {
  const std::size_t n = lattice.size();
  std::vector<int> level(n, 0);
  CycleCells sons(n);
  for (std::size_t k = 0; k < n; ++k) {
    sons[k].push_back(k);
    for (std::size_t h = 0; h < n; ++h) {
      level[h] += lattice[k][h];
      if (lattice[k][h] == 1) sons[k].push_back(h);
    }
  }
  const auto by_level = [&](std::size_t first, std::size_t second) {
    return level[first] < level[second];
  };
  std::stable_sort(sons.begin(), sons.end(), [&](const auto& first, const auto& second) {
    return std::lexicographical_compare(first.begin(), first.end(), second.begin(), second.end(),
                                        by_level);
  });
  CycleCells result;
  std::vector<bool> used(n, false);
  for (const std::vector<std::size_t>& family : sons) {
    const std::size_t father = family.front();
    std::vector<std::size_t> cell;
    for (const std::size_t son : family) {
      if (level[son] - level[father] <= 1) cell.push_back(son);
    }
    if (used[cell.front()]) continue;
    for (const std::size_t cycle : cell) used[cycle] = true;
    result.push_back(std::move(cell));
  }
  return result;
}

}  // namespace plumbline::inters

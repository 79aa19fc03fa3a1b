#include "engines/lar/stages/crowds.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumbline::lar {
namespace {

/// Half a radius: the diagonal of a cell is 0.71 radii. Cells are numbered up to 2^47, so dividing
/// moves a point by less than a tenth of a cell.
constexpr double kCellsPerRadius = 2;
/// Two cells cover the radius; one more for the rounding.
constexpr std::int64_t kReach = 3;
/// Below this many points searching costs less than looking at the cells around.
constexpr std::size_t kCrowded = 16;

}  // namespace

Crowds::Crowds(std::span<const PointD> points, double radius, UnionFind& classes)
    : classes_(classes) {
  const auto number = [radius](double coordinate) {
    return static_cast<std::int64_t>(std::floor(coordinate / radius * kCellsPerRadius));
  };
  for (const PointD& p : points) cell_of_.push_back({number(p.x), number(p.y)});
  std::vector<std::size_t> by_cell(points.size());
  std::iota(by_cell.begin(), by_cell.end(), std::size_t{0});
  std::sort(by_cell.begin(), by_cell.end(),
            [&](std::size_t i, std::size_t j) { return cell_of_[i] < cell_of_[j]; });
  for (std::size_t i : by_cell) {
    if (crowds_.empty() || crowds_.back().cell != cell_of_[i]) {
      crowds_.push_back({cell_of_[i], i, 0});
    }
    ++crowds_.back().size;
    classes_.unite(crowds_.back().first, i);
  }
}

std::vector<std::size_t> Crowds::representatives() const {
  std::vector<std::size_t> result;
  for (const Crowd& crowd : crowds_) {
    if (crowd.size >= kCrowded) result.push_back(crowd.first);
  }
  return result;
}

bool Crowds::is_united_around(std::size_t point) {
  const auto before = [](const Crowd& crowd, const Cell& cell) { return crowd.cell < cell; };
  const auto find = [&](const Cell& cell) {
    return std::lower_bound(crowds_.begin(), crowds_.end(), cell, before);
  };
  const Cell cell = cell_of_[point];
  if (find(cell)->size < kCrowded) return false;
  for (std::int64_t x = cell.x - kReach; x <= cell.x + kReach; ++x) {
    for (auto crowd = find({x, cell.y - kReach});
         crowd != crowds_.end() && crowd->cell <= Cell{x, cell.y + kReach}; ++crowd) {
      if (classes_.find(crowd->first) != classes_.find(point)) return false;
    }
  }
  return true;
}

}  // namespace plumbline::lar

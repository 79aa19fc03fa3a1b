#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/union_find.hpp"
#include "plumbline/geometry.hpp"

namespace plumbline::lar {

/// A grid whose cells are so small that points of one cell are near each other. It keeps merging
/// from listing all near pairs where many points crowd within the radius. Unites the points of each
/// cell when made.
class Crowds {
 public:
  Crowds(std::span<const PointD> points, double radius, UnionFind& classes);
  /// A point of every crowded cell.
  std::vector<std::size_t> representatives() const;
  /// Whether the point is in a crowded cell and all points that can be near it are in its class
  /// already. May say no where that is so.
  bool is_united_around(std::size_t point);

 private:
  struct Cell {
    std::int64_t x, y;
    friend auto operator<=>(const Cell&, const Cell&) = default;
  };
  struct Crowd {
    Cell cell;
    std::size_t first;  ///< one of its points
    std::size_t size;
  };
  std::vector<Cell> cell_of_;  ///< per point
  std::vector<Crowd> crowds_;  ///< ascending by cell
  UnionFind& classes_;
};

}  // namespace plumbline::lar

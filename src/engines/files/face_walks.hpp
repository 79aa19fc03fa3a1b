#pragma once

#include <optional>
#include <vector>

#include "plumbline/engine/cell_lists.hpp"

namespace plumbline::files {

/// The walks around the faces of a graph with straight edges: what a cell of LAR means that lists
/// the vertices of its boundary in any order, where the graph has other edges among them, too.
/// Dangling edges are left out. The order of edges around a vertex is that of their angles, which
/// is exact; whether edges cross is not asked. Cost: O(n log n).
class FaceWalks {
 public:
  using Cell = std::vector<VertexId>;

  /// `neighbours` per vertex.
  FaceWalks(const std::vector<PointD>& vertices, std::vector<Cell> neighbours);

  /// The face that has just these vertices on its outer boundary and on the outlines of what lies
  /// in it; none where there is no such face, or more than one. Requires: vertices, ascending.
  std::optional<Polygon> around(const Cell& vertices) const;

 private:
  void leave_out_dangling();
  void sort_by_angle();
  void walk();
  std::optional<std::vector<Cell>> outlines_of(Cell rest) const;

  const std::vector<PointD>& vertices_;
  std::vector<Cell> neighbours_;
  std::vector<Cell> inner_, outer_;                            ///< counter-clockwise, clockwise
  std::vector<std::vector<std::size_t>> inner_at_, outer_at_;  ///< those through each vertex
};

}  // namespace plumbline::files

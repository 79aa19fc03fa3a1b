// The containment lattice, by its least elements only: per point the smallest cycle around it. The
// cycles of a planar drawing that contain a point are nested, so the innermost is that of least
// area. Points are found for each cycle by its box, along the axis that leaves fewer of them.

#include <algorithm>
#include <numeric>

#include "engines/lar/stages/points.hpp"
#include "geometry/point_d.hpp"
#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {
namespace {

using Positions = std::vector<std::size_t>;

std::vector<PointD> polygon(const Graph& graph, std::span<const HalfedgeId> cycle) {
  std::vector<PointD> points;
  for (HalfedgeId h : cycle) {
    const Edge& edge = graph.edges[edge_of(h)];
    points.push_back(graph.vertices[is_reversed(h) ? edge.head : edge.tail]);
  }
  return points;
}

/// Points sorted along both axes, for queries by box.
class PointsInBox {
 public:
  explicit PointsInBox(std::vector<PointD> points) : points_(std::move(points)) {
    for (std::size_t axis : {0U, 1U}) {
      order_[axis].resize(points_.size());
      std::iota(order_[axis].begin(), order_[axis].end(), std::size_t{0});
      std::stable_sort(order_[axis].begin(), order_[axis].end(), [&](std::size_t i, std::size_t j) {
        return coordinate(i, axis) < coordinate(j, axis);
      });
    }
  }

  const PointD& operator[](std::size_t i) const { return points_[i]; }

  /// The points strictly inside the box.
  Positions inside(const BoxD& box) const {
    const auto by_x = between(box.low.x, box.high.x, 0);
    const auto by_y = between(box.low.y, box.high.y, 1);
    Positions result;
    for (std::size_t i : by_x.size() < by_y.size() ? by_x : by_y) {
      const PointD& p = points_[i];
      if (box.low.x < p.x && p.x < box.high.x && box.low.y < p.y && p.y < box.high.y) {
        result.push_back(i);
      }
    }
    return result;
  }

 private:
  double coordinate(std::size_t i, std::size_t axis) const {
    return axis == 0 ? points_[i].x : points_[i].y;
  }
  std::span<const std::size_t> between(double low, double high, std::size_t axis) const {
    const Positions& order = order_[axis];
    const auto first =
        std::upper_bound(order.begin(), order.end(), low,
                         [&](double c, std::size_t i) { return c < coordinate(i, axis); });
    const auto last = std::lower_bound(
        first, order.end(), high, [&](std::size_t i, double c) { return coordinate(i, axis) < c; });
    return {first, last};
  }

  std::vector<PointD> points_;
  Positions order_[2];
};

}  // namespace

std::vector<CycleId> innermost_cycles(const Graph& graph, const Lists<HalfedgeId>& cycles,
                                      std::span<const double> areas, std::span<const CycleId> outer,
                                      std::span<const VertexId> vertices) {
  std::vector<PointD> points;
  for (VertexId v : vertices) points.push_back(graph.vertices[v]);
  const PointsInBox queries(std::move(points));
  std::vector<CycleId> innermost(vertices.size());
  for (CycleId c : outer) {
    const std::vector<PointD> boundary = polygon(graph, cycles[c]);
    const Positions candidates = queries.inside(box_of(boundary));
    if (candidates.empty()) continue;
    std::vector<PointD> candidate_points;
    for (std::size_t i : candidates) candidate_points.push_back(queries[i]);
    const std::vector<Position> position = classify_points(boundary, candidate_points);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      CycleId& best = innermost[candidates[k]];
      if (position[k] == Position::In && (!best.valid() || areas[c] < areas[best])) best = c;
    }
  }
  return innermost;
}

}  // namespace plumbline::lar

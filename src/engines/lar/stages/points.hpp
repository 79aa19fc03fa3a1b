#pragma once

#include <span>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::lar {

inline double squared_distance(const PointD& p, const PointD& q) {
  const double dx = p.x - q.x;
  const double dy = p.y - q.y;
  return dx * dx + dy * dy;
}
/// Whether two points are no further apart than the radius: the one rule for "near" of all stages.
inline bool near(const PointD& p, const PointD& q, double radius) {
  return squared_distance(p, q) <= radius * radius;
}
/// The largest absolute coordinate; 0 for no points.
double largest_coordinate(std::span<const PointD> points);
/// The points in ascending order, equal ones once.
std::vector<PointD> sorted_unique(std::vector<PointD> points);
/// The position of p. Requires: `vertices` ascending, p among them.
VertexId find_vertex(std::span<const PointD> vertices, const PointD& p);

}  // namespace plumbline::lar

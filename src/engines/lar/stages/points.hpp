#pragma once

#include <span>
#include <vector>

#include "geometry/point_d.hpp"
#include "plumbline/complex.hpp"

namespace plumbline::lar {

/// Whether two points are no further apart than the radius: the one rule for "near" of all stages.
inline bool near(const PointD& p, const PointD& q, double radius) {
  return squared_distance(p, q) <= radius * radius;
}
/// The points in ascending order, equal ones once.
std::vector<PointD> sorted_unique(std::vector<PointD> points);
/// The position of p. Requires: `vertices` ascending, p among them.
VertexId find_vertex(std::span<const PointD> vertices, const PointD& p);

}  // namespace plumbline::lar

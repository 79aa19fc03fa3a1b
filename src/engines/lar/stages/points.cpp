#include "engines/lar/stages/points.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::lar {

double largest_coordinate(std::span<const PointD> points) {
  double largest = 0;
  for (const PointD& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest;
}

std::vector<PointD> sorted_unique(std::vector<PointD> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

VertexId find_vertex(std::span<const PointD> vertices, const PointD& p) {
  return VertexId(std::lower_bound(vertices.begin(), vertices.end(), p) - vertices.begin());
}

}  // namespace plumbline::lar

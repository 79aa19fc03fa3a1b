#include "engines/lar/stages/points.hpp"

#include <algorithm>

namespace plumbline::lar {

std::vector<PointD> sorted_unique(std::vector<PointD> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

VertexId find_vertex(std::span<const PointD> vertices, const PointD& p) {
  return VertexId(std::lower_bound(vertices.begin(), vertices.end(), p) - vertices.begin());
}

}  // namespace plumbline::lar

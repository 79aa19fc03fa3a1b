// How wide a face is: the largest circle in it.

#include <algorithm>
#include <cmath>

#include "coverage/steps.hpp"
#include "rooms/inscribed_circle.hpp"

namespace plumbline::coverage_steps {

double length(const ExactComplex& complex, EdgeId e) {
  const Edge& edge = complex.edges[e];
  return std::sqrt(
      nearest_double(squared_distance(complex.vertices[edge.tail], complex.vertices[edge.head])));
}

double width(const ExactComplex& complex, FaceId face, std::span<const EdgeId> edges,
             const Rational& area) {
  // About one of its own vertices, so that narrow faces far from (0, 0) keep their digits.
  const Point origin = complex.vertices[complex.edges[edges.front()].tail];
  const auto place = [&](VertexId v) {
    const Point p = complex.vertices[v];
    return PointD{nearest_double(p.x - origin.x), nearest_double(p.y - origin.y)};
  };
  std::vector<SegmentD> sides;
  double perimeter = 0;
  for (const EdgeId e : edges) {
    sides.push_back({place(complex.edges[e].tail), place(complex.edges[e].head)});
    perimeter += length(complex, e);
  }
  const double mean = 2 * nearest_double(area) / perimeter;
  constexpr std::size_t kTriangle = 3;
  if (edges.size() == kTriangle) return 2 * mean;
  // With one hole or none a circle of the diameter `mean` fits in: the lines at some distance from
  // the boundary are together no longer than it is (Sz.-Nagy 1959).
  const bool has_few_holes = complex.face_holes[face].size() < 2;
  constexpr double kSurely = 0.99;
  const double least = has_few_holes ? kSurely * mean / 2 : 0;
  const double found = 2 * rooms_steps::inscribed_circle(sides, least).radius;
  return has_few_holes ? std::max(found, mean) : found;
}

}  // namespace plumbline::coverage_steps

// A horizontal line half-way between two successive heights of the face's vertices meets its
// boundary only inside edges. Along it, real boundary edges alternately enter and leave the face;
// antennas only divide it. The middle of the widest piece inside is strictly interior.

#include <algorithm>
#include <utility>

#include "plumbline/complex.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

std::vector<HalfedgeId> boundary_halfedges(const Incidences& c, FaceId f) {
  std::vector<HalfedgeId> halfedges;
  const auto add = [&](CycleId cycle) {
    halfedges.insert(halfedges.end(), c.cycles[cycle].begin(), c.cycles[cycle].end());
  };
  add(c.face_outer[f]);
  for (const CycleId hole : c.face_holes[f]) add(hole);
  return halfedges;
}

/// The middle of the tallest strip between successive heights of the outer boundary's extent.
Rational scan_height(const ExactComplex& c, FaceId f, const std::vector<HalfedgeId>& boundary) {
  std::vector<Rational> heights;
  for (const HalfedgeId h : boundary) heights.push_back(c.vertices[c.origin(h)].y);
  for (const VertexId v : c.face_isolated_vertices[f]) heights.push_back(c.vertices[v].y);
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  ensure(heights.size() >= 2, "a bounded face has an extent");
  std::size_t tallest = 1;
  for (std::size_t i = 2; i < heights.size(); ++i) {
    if (heights[i] - heights[i - 1] > heights[tallest] - heights[tallest - 1]) tallest = i;
  }
  return (heights[tallest - 1] + heights[tallest]) / 2;
}

struct Meeting {
  Rational x;
  bool antenna;
};

}  // namespace

Point interior_point(const ExactComplex& complex, FaceId f) {
  ensure(f != kUnbounded && f < complex.face_count(),
         "an interior point is asked of a bounded face");
  const std::vector<HalfedgeId> boundary = boundary_halfedges(complex, f);
  const Rational y = scan_height(complex, f, boundary);
  std::vector<Meeting> meetings;
  for (const HalfedgeId h : boundary) {
    const Point& p = complex.vertices[complex.origin(h)];
    const Point& q = complex.vertices[complex.target(h)];
    if ((p.y < y) == (q.y < y)) continue;
    meetings.push_back(
        {p.x + (q.x - p.x) * (y - p.y) / (q.y - p.y), complex.is_antenna(edge_of(h))});
  }
  std::sort(meetings.begin(), meetings.end(),
            [](const Meeting& a, const Meeting& b) { return a.x < b.x; });
  bool inside = false;
  Rational widest = 0, x = 0;
  for (std::size_t i = 0; i + 1 < meetings.size(); ++i) {
    if (!meetings[i].antenna) inside = !inside;
    const Rational width = meetings[i + 1].x - meetings[i].x;
    if (!inside || width <= widest) continue;
    widest = width;
    x = (meetings[i].x + meetings[i + 1].x) / 2;
  }
  ensure(widest > 0, "a bounded face has an interior");
  return {x, y};
}

}  // namespace plumbline

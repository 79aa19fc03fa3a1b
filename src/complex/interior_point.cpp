// A horizontal line half-way between two successive heights of the face's vertices meets its
// boundary only inside edges. Along it, real boundary edges alternately enter and leave the face;
// antennas only divide it. The middle of the widest piece inside is strictly interior.

#include <algorithm>
#include <utility>

#include "plumbline/complex.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

/// A halfedge of the boundary.
struct Side {
  Point from;
  std::size_t next;  ///< the side that begins where it ends
  bool is_antenna;
};

std::vector<Side> boundary_of(const ExactComplex& c, FaceId f) {
  std::vector<Side> sides;
  std::size_t count = c.cycles[c.face_outer[f]].size();
  for (const CycleId hole : c.face_holes[f]) count += c.cycles[hole].size();
  sides.reserve(count);
  const auto add = [&](CycleId cycle) {
    const std::size_t first = sides.size();
    for (const HalfedgeId h : c.cycles[cycle]) {
      sides.push_back({c.vertices[c.origin(h)], sides.size() + 1, c.is_antenna(edge_of(h))});
    }
    sides.back().next = first;
  };
  add(c.face_outer[f]);
  for (const CycleId hole : c.face_holes[f]) add(hole);
  return sides;
}

/// The middle of the tallest strip between successive heights of the outer boundary's extent.
Rational scan_height(const ExactComplex& c, FaceId f, const std::vector<Side>& boundary) {
  std::vector<Rational> heights;
  heights.reserve(boundary.size() + c.face_isolated_vertices[f].size());
  for (const Side& side : boundary) heights.push_back(side.from.y);
  for (const VertexId v : c.face_isolated_vertices[f]) heights.push_back(c.vertices[v].y);
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  ensure(heights.size() >= 2, "a bounded face has an extent");
  std::size_t tallest = 1;
  Rational height = heights[1] - heights[0];
  for (std::size_t i = 2; i < heights.size(); ++i) {
    Rational other = heights[i] - heights[i - 1];
    if (other <= height) continue;
    height = std::move(other);
    tallest = i;
  }
  return (heights[tallest - 1] + heights[tallest]) / 2;
}

/// Where the line at height y meets the side from p to q: x is (p.x s + q.x t) / (s + t) with
/// s = q.y - y and t = y - p.y, brought to lowest terms once.
Rational crossing(const Point& p, const Point& q, const Rational& y) {
  const Rational s = q.y - y, t = y - p.y;
  const mpz_class st = s.get_num() * t.get_den(), ts = t.get_num() * s.get_den();
  const mpz_class &p_d = p.x.get_den(), &q_d = q.x.get_den();
  Rational x(p.x.get_num() * q_d * st + q.x.get_num() * p_d * ts, p_d * q_d * (st + ts));
  x.canonicalize();
  return x;
}

struct Meeting {
  Rational x;
  bool antenna;
};

}  // namespace

Point interior_point(const ExactComplex& complex, FaceId f) {
  ensure(f != kUnbounded && f < complex.face_count(),
         "an interior point is asked of a bounded face");
  const std::vector<Side> boundary = boundary_of(complex, f);
  const Rational y = scan_height(complex, f, boundary);
  std::vector<Meeting> meetings;
  for (const Side& side : boundary) {
    const Point& to = boundary[side.next].from;
    if ((side.from.y < y) == (to.y < y)) continue;
    meetings.push_back({crossing(side.from, to, y), side.is_antenna});
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

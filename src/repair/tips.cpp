#include "repair/tips.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "geometry/point_d.hpp"

namespace plumbline::repair_steps {
namespace {

/// What all points of a line share: whether it is vertical, its slope, its height at x = 0 or its
/// x.
using Slope = std::tuple<bool, Rational, Rational>;

Slope slope_of(const Tip& tip) {
  if (sgn(tip.direction.x) == 0) return {true, 0, tip.point.x};
  const Rational slope = tip.direction.y / tip.direction.x;
  return {false, slope, tip.point.y - slope * tip.point.x};
}

/// A factor that makes a vector at least so long, and little longer.
Rational stretch_to(const Point& v, const Rational& length) {
  const double factor =
      nearest_double(length) / quick_length({nearest_double(v.x), nearest_double(v.y)});
  int exponent = 0;
  const double mantissa = std::frexp(factor, &exponent);  // in [1/2, 1)
  return rational_from(std::ldexp(std::ceil(mantissa * 256) + 1, exponent - 8));
}

}  // namespace

std::vector<Tip> growing_tips(const Work& work, const Arranged& arranged) {
  const ExactComplex& complex = arranged.complex;
  std::vector<std::uint32_t> degree(complex.vertices.size());
  for (const Edge& edge : complex.edges) {
    ++degree[edge.tail];
    ++degree[edge.head];
  }
  std::vector<Tip> tips;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const Edge& edge = complex.edges[e];
    for (const VertexId v : {edge.tail, edge.head}) {
      if (degree[v] != 1) continue;
      const std::vector<LineId> lines = arranged.lines(EdgeId(e));
      if (std::ranges::any_of(
              lines, [&](LineId id) { return work.is_anchored(id) || work.is_virtual(id); })) {
        continue;
      }
      const LineId id = lines.front();
      const Line line = work.line(id);
      const Point tip = complex.vertices[v];
      const Point& from = line.a == tip ? line.b : line.a;
      tips.push_back({v, tip, id, {tip.x - from.x, tip.y - from.y}});
    }
  }
  std::ranges::sort(tips, {}, &Tip::vertex);
  return tips;
}

std::vector<Segment> tracks_of(const std::vector<Tip>& tips, const Rational& reach) {
  std::vector<Segment> tracks;
  for (const Tip& tip : tips) {
    const Rational s = stretch_to(tip.direction, reach);
    tracks.push_back(
        {tip.point, {tip.point.x + s * tip.direction.x, tip.point.y + s * tip.direction.y}});
  }
  return tracks;
}

std::vector<std::pair<std::size_t, std::size_t>> facing_pairs(const std::vector<Tip>& tips) {
  std::map<Slope, std::vector<std::size_t>> on_line;  // ascending, as vertices are
  for (std::size_t t = 0; t < tips.size(); ++t) on_line[slope_of(tips[t])].push_back(t);
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (const auto& [slope, members] : on_line) {
    for (std::size_t i = 1; i < members.size(); ++i) {
      const std::size_t t = members[i - 1], u = members[i];
      if (is_forward(tips[t].direction) && !is_forward(tips[u].direction)) {
        result.emplace_back(t, u);
      }
    }
  }
  std::ranges::sort(result);
  return result;
}

}  // namespace plumbline::repair_steps

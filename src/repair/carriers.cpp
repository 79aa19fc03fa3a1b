#include "repair/carriers.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/edge_tree.hpp"
#include "geometry/union_find.hpp"

namespace plumbline::repair_steps {
namespace {

/// Pairs of lines that end at one vertex, on both sides of it, on one line.
void unite_continuing(const Arranged& arranged, UnionFind& sets) {
  const ExactComplex& complex = arranged.complex;
  std::vector<std::vector<EdgeId>> left(complex.vertices.size());  // edges that end there
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    left[complex.edges[e].head].emplace_back(e);
  }
  const std::vector<PointD> rounded = nearest(complex).vertices;
  const double slack = 0x1p-40;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const Edge& edge = complex.edges[e];
    for (const EdgeId f : left[edge.tail]) {
      if (sets.find(complex.edge_sources[e][0]) == sets.find(complex.edge_sources[f][0])) continue;
      const PointD &p = rounded[complex.edges[f].tail], &q = rounded[edge.tail],
                   &r = rounded[edge.head];
      const double ux = q.x - p.x, uy = q.y - p.y, vx = r.x - q.x, vy = r.y - q.y;
      const double scale = (std::abs(ux) + std::abs(uy)) * (std::abs(vx) + std::abs(vy));
      const double size = std::max({std::abs(q.x), std::abs(q.y), 1e-300});
      if (std::abs(ux * vy - uy * vx) >
          slack * (scale + size * (std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy)))) {
        continue;
      }
      if (orientation(complex.vertices[complex.edges[f].tail], complex.vertices[edge.tail],
                      complex.vertices[edge.head]) == 0) {
        sets.unite(complex.edge_sources[e][0], complex.edge_sources[f][0]);
      }
    }
    for (const SegmentId s : complex.edge_sources[e]) sets.unite(s, complex.edge_sources[e][0]);
  }
}

struct Between {
  Point p, d;  ///< a point, and a direction
};
Between through(const Carrier& c) { return {c.a, {c.b.x - c.a.x, c.b.y - c.a.y}}; }

}  // namespace

bool is_stronger(const Carrier& c, const Carrier& d) {
  if (c.is_anchored != d.is_anchored) return c.is_anchored;
  const int by_length = cmp(c.squared_length, d.squared_length);
  if (by_length != 0) return by_length > 0;
  return c.a == d.a ? c.b < d.b : c.a < d.a;
}

Carriers carriers_of(const Work& work, const Arranged& arranged) {
  UnionFind sets(arranged.line_of.size());
  unite_continuing(arranged, sets);
  Carriers result;
  std::vector<std::size_t> number(arranged.line_of.size(), arranged.line_of.size());
  for (std::size_t s = 0; s < arranged.line_of.size(); ++s) {
    const Line line = work.line(arranged.line_of[s]);
    std::size_t& carrier = number[sets.find(s)];
    if (carrier == arranged.line_of.size()) {
      carrier = result.carriers.size();
      result.carriers.push_back({line.a, line.b, {}, false, 0});
    }
    Carrier& c = result.carriers[carrier];
    c.a = std::min(c.a, line.a);
    c.b = std::max(c.b, line.b);
    c.lines.push_back(arranged.line_of[s]);
    c.is_anchored = c.is_anchored || work.is_anchored(c.lines.back());
    result.of_line.push_back(carrier);
  }
  for (Carrier& c : result.carriers) c.squared_length = squared_distance(c.a, c.b);
  return result;
}

std::vector<std::pair<std::size_t, std::size_t>> side_by_side(const Work& work,
                                                              const Arranged& arranged,
                                                              const Rational& distance) {
  std::vector<Edge> edges;
  std::vector<PointD> ends;
  for (const LineId id : arranged.line_of) {
    const SegmentD line = work.rounded(id);
    edges.push_back({VertexId(ends.size()), VertexId(ends.size() + 1)});
    ends.push_back(line.a);
    ends.push_back(line.b);
  }
  const diagnose_steps::EdgeTree tree(edges, ends);
  const double slack = largest_coordinate(ends) * 0x1p-45;
  const double reach = nearest_double(distance) * (1 + 0x1p-30) + slack;
  std::vector<std::pair<std::size_t, std::size_t>> result;
  const auto unit = [&](std::size_t i) {
    const PointD d{ends[2 * i + 1].x - ends[2 * i].x, ends[2 * i + 1].y - ends[2 * i].y};
    const double length = quick_length(d);
    return std::pair(PointD{d.x / length, d.y / length}, length);
  };
  for (std::size_t end = 0; end < ends.size(); ++end) {
    const std::size_t i = end / 2;
    const auto [u, length] = unit(i);
    tree.visit(ends[end], reach, [&](EdgeId e, const auto& /*foot*/) {
      const std::size_t j = e;
      if (j == i) return;
      const auto [v, other] = unit(j);
      // Both ends of the shorter one are beside the other: it deviates by no more than that.
      if (std::abs(u.x * v.y - u.y * v.x) * std::min(length, other) > 2 * reach) return;
      result.emplace_back(std::min(i, j), std::max(i, j));
    });
  }
  std::ranges::sort(result);
  const auto repeated = std::ranges::unique(result);
  result.erase(repeated.begin(), repeated.end());
  return result;
}

Point foot(const Carrier& c, const Point& p) {
  const auto [a, d] = through(c);
  if (sgn(d.x) == 0) return {a.x, p.y};
  if (sgn(d.y) == 0) return {p.x, a.y};
  const Rational t = ((p.x - a.x) * d.x + (p.y - a.y) * d.y) / c.squared_length;
  return {a.x + t * d.x, a.y + t * d.y};
}

std::optional<Point> meeting(const Carrier& c, const Carrier& d) {
  const auto [p, u] = through(c);
  const auto [q, v] = through(d);
  const Rational k = u.x * v.y - u.y * v.x;
  if (sgn(k) == 0) return std::nullopt;
  const Rational t = ((q.x - p.x) * v.y - (q.y - p.y) * v.x) / k;
  return Point{p.x + t * u.x, p.y + t * u.y};
}

Rational squared_distance_from(const Carrier& c, const Point& p) {
  const Rational across = (c.b.x - c.a.x) * (p.y - c.a.y) - (c.b.y - c.a.y) * (p.x - c.a.x);
  return across * across / c.squared_length;
}

}  // namespace plumbline::repair_steps

#include "repair/carriers.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/edge_tree.hpp"
#include "geometry/box_tree.hpp"

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

/// A line in doubles.
struct Ends {
  Ends(const SegmentD& segment, bool made_lately) : line(segment), is_new(made_lately) {
    const PointD d{line.b.x - line.a.x, line.b.y - line.a.y};
    length = quick_length(d);
    unit = {d.x / length, d.y / length};
  }

  SegmentD line;
  bool is_new;
  double length;
  PointD unit;
};

/// The new lines, and what may be within reach of one of them. Ascending.
std::vector<std::size_t> around_new(const std::vector<Ends>& lines, double reach) {
  std::vector<BoxD> boxes;
  for (const Ends& line : lines) {
    const std::array ends = {line.line.a, line.line.b};
    if (line.is_new) boxes.push_back(grown(box_of(ends), reach));
  }
  const bool all_new = boxes.size() == lines.size();
  const BoxTree tree(all_new ? std::span<const BoxD>() : std::span<const BoxD>(boxes));
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].is_new || !tree.meeting(lines[i].line).empty()) result.push_back(i);
  }
  return result;
}

/// Calls visit(i, j) where an end of line i is within reach of line j and one of them is new.
template <class Visit>
void for_each_near_end(const std::vector<Ends>& lines, double reach, const Visit& visit) {
  const std::vector<std::size_t> some = around_new(lines, reach);
  std::vector<Edge> edges;
  std::vector<PointD> ends;
  std::vector<std::pair<PointD, std::size_t>> lines_at;  // by their ends
  for (const std::size_t i : some) {
    edges.push_back({VertexId(ends.size()), VertexId(ends.size() + 1)});
    for (const PointD& end : {lines[i].line.a, lines[i].line.b}) {
      ends.push_back(end);
      lines_at.emplace_back(end, i);
    }
  }
  std::ranges::sort(lines_at, [](const auto& p, const auto& q) {
    return p.first == q.first ? p.second < q.second : p.first < q.first;
  });
  const diagnose_steps::EdgeTree tree(edges, ends);
  std::vector<std::size_t> near;
  for (auto at = lines_at.begin(); at != lines_at.end();) {
    const PointD p = at->first;
    near.clear();
    tree.visit(p, reach, [&](EdgeId e, const auto& /*foot*/) { near.push_back(some[e]); });
    for (; at != lines_at.end() && at->first == p; ++at) {
      const std::size_t i = at->second;
      for (const std::size_t j : near) {
        if (i != j && (lines[i].is_new || lines[j].is_new)) visit(i, j);
      }
    }
  }
}

/// Whether lines may lie beside each other for more than the reach: both ends of the shorter one,
/// then, are near the other one.
bool may_be_beside(const Ends& p, const Ends& q, double reach) {
  const Ends &shorter = p.length < q.length ? p : q, &longer = p.length < q.length ? q : p;
  const double turn = shorter.unit.x * longer.unit.y - shorter.unit.y * longer.unit.x;
  if (std::abs(turn) * shorter.length > 2 * reach) return false;
  const auto along = [&](const PointD& r) {
    return (r.x - longer.line.a.x) * longer.unit.x + (r.y - longer.line.a.y) * longer.unit.y;
  };
  const double t = along(shorter.line.a), u = along(shorter.line.b);
  return std::min(std::max(t, u), longer.length) - std::max(std::min(t, u), 0.0) > reach * 0.99;
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

Carriers::Carriers(const Work& work, const Arranged& arranged)
    : work_(work),
      arranged_(arranged),
      sets_(arranged.line_of.size()),
      members_(arranged.line_of.size()) {
  unite_continuing(arranged, sets_);
  for (std::size_t i = 0; i < members_.size(); ++i) {
    members_[sets_.find(i)].push_back(static_cast<std::uint32_t>(i));
  }
  edges_at_.resize(arranged.complex.vertices.size());
  for (std::size_t e = 0; e < arranged.complex.edge_count(); ++e) {
    edges_at_[arranged.complex.edges[e].tail].emplace_back(e);
    edges_at_[arranged.complex.edges[e].head].emplace_back(e);
  }
}

const Carrier& Carriers::operator[](std::size_t carrier) {
  const auto [place, is_new] = made_.try_emplace(carrier);
  Carrier& c = place->second;
  if (!is_new) return c;
  for (const std::uint32_t i : members_[carrier]) {
    const LineId id = arranged_.line_of[i];
    Line line = work_.line(id);
    const bool is_first = c.lines.empty();
    if (is_first || line.a < c.a) c.a = std::move(line.a);
    if (is_first || c.b < line.b) c.b = std::move(line.b);
    c.lines.push_back(id);
    c.is_anchored = c.is_anchored || work_.is_anchored(id);
  }
  c.squared_length = squared_distance(c.a, c.b);
  c.is_curved = turns_slightly(c.a, c.b) || turns_slightly(c.b, c.a);
  return c;
}

bool Carriers::turns_slightly(const Point& end, const Point& from) const {
  // Squared tangents of one degree and of thirty.
  const Rational least(1, 3282), most(1, 3);
  const PointList& vertices = arranged_.complex.vertices;
  const std::size_t v = vertices.count_before(end);
  const Point d{end.x - from.x, end.y - from.y};
  return std::ranges::any_of(edges_at_[v], [&](EdgeId e) {
    const Edge& edge = arranged_.complex.edges[e];
    const Point other = vertices[edge.tail == VertexId(v) ? edge.head : edge.tail];
    const Point u{other.x - end.x, other.y - end.y};
    const Rational along = d.x * u.x + d.y * u.y;
    if (sgn(along) <= 0) return false;
    const Rational turn = d.x * u.y - d.y * u.x;
    const Rational squared = turn * turn / (along * along);
    return squared >= least && squared <= most;
  });
}

std::vector<char> Carriers::are_new(LineId first_new) {
  std::vector<char> has_new(arranged_.line_of.size()), result;
  for (std::size_t i = 0; i < has_new.size(); ++i) {
    if (arranged_.line_of[i] >= first_new) has_new[of_line(i)] = 1;
  }
  for (std::size_t i = 0; i < has_new.size(); ++i) result.push_back(has_new[of_line(i)]);
  return result;
}

std::vector<std::pair<std::size_t, std::size_t>> side_by_side(const Work& work,
                                                              const Arranged& arranged,
                                                              const Rational& distance,
                                                              const std::vector<char>& is_new) {
  // Where two lines lie side by side, an end of one of them is near the other.
  std::vector<Ends> lines;
  double largest = 0;
  for (const LineId id : arranged.line_of) {
    lines.emplace_back(work.rounded(id), is_new[lines.size()] != 0);
    largest = std::max({largest, std::abs(lines.back().line.a.x), std::abs(lines.back().line.a.y),
                        std::abs(lines.back().line.b.x), std::abs(lines.back().line.b.y)});
  }
  const double reach = nearest_double(distance) * (1 + 0x1p-30) + largest * 0x1p-45;
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for_each_near_end(lines, reach, [&](std::size_t i, std::size_t j) {
    if (may_be_beside(lines[i], lines[j], reach)) {
      result.emplace_back(std::min(i, j), std::max(i, j));
    }
  });
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
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

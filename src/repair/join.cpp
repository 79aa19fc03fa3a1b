// Loose ends on parallel lines that face each other, near each other but not on one line, are
// joined straight where each is the only one for the other.

#include <algorithm>
#include <map>

#include "geometry/box_tree.hpp"
#include "geometry/point_tree.hpp"
#include "repair/steps.hpp"
#include "repair/tips.hpp"

namespace plumbline::repair_steps {
namespace {

Rational dot(const Point& u, const Point& v) { return u.x * v.x + u.y * v.y; }
Rational cross(const Point& u, const Point& v) { return u.x * v.y - u.y * v.x; }

using Pair = std::pair<std::size_t, std::size_t>;  // of tips

/// Whether they lead to each other on two parallel lines.
bool are_facing(const Tip& t, const Tip& u) {
  if (sgn(cross(t.direction, u.direction)) != 0 || sgn(dot(t.direction, u.direction)) > 0) {
    return false;
  }
  const Point way{u.point.x - t.point.x, u.point.y - t.point.y};
  return sgn(cross(t.direction, way)) != 0 && sgn(dot(t.direction, way)) >= 0;
}

std::vector<Pair> facing_near(const std::vector<Tip>& tips, const Rational& reach) {
  std::vector<PointD> points;
  for (const Tip& tip : tips) points.push_back(nearest(tip.point));
  const PointTree tree(points);
  const double radius =
      nearest_double(reach) * (1 + 0x1p-20) + largest_coordinate(points) * 0x1p-45;
  const Rational squared_reach = reach * reach;
  std::vector<Pair> result;
  for (std::size_t t = 0; t < tips.size(); ++t) {
    tree.for_each_near(points[t], radius, [&](std::size_t u) {
      if (u > t && squared_distance(tips[t].point, tips[u].point) <= squared_reach &&
          are_facing(tips[t], tips[u])) {
        result.emplace_back(t, u);
      }
    });
  }
  std::ranges::sort(result);
  return result;
}

/// Whether a line meets the way from p to q, its ends excepted.
bool blocks(const Line& line, const Point& p, const Point& q) {
  const auto is_inside = [&](const Point& x) { return x != p && x != q && on_segment(p, q, x); };
  if (is_inside(line.a) || is_inside(line.b)) return true;
  const int a = orientation(p, q, line.a), b = orientation(p, q, line.b);
  const int c = orientation(line.a, line.b, p), d = orientation(line.a, line.b, q);
  return (a * b < 0 && c * d < 0) ||
         (a == 0 && b == 0 && on_segment(line.a, line.b, p) && on_segment(line.a, line.b, q));
}

/// Which ways no line blocks.
std::vector<char> are_clear(const Work& work, const Arranged& arranged,
                            const std::vector<Tip>& tips, const std::vector<Pair>& pairs) {
  std::vector<BoxD> boxes;
  for (const auto& [t, u] : pairs) {
    const std::array ends = {nearest(tips[t].point), nearest(tips[u].point)};
    boxes.push_back(grown(box_of(ends), largest_coordinate(ends) * 0x1p-40));
  }
  const BoxTree tree(boxes);
  std::vector<char> result(pairs.size(), 1);
  for (const LineId id : arranged.line_of) {
    for (const std::size_t i : tree.meeting(work.rounded(id))) {
      const auto [t, u] = pairs[i];
      if (blocks(work.line(id), tips[t].point, tips[u].point)) result[i] = 0;
    }
  }
  return result;
}

}  // namespace

void join_offset_ends(Work& work, const Arranged& arranged, const Rational& reach) {
  const std::vector<Tip> tips = growing_tips(work, arranged);
  std::vector<Pair> pairs = facing_near(tips, reach);
  if (pairs.empty()) return;
  const std::vector<char> clear = are_clear(work, arranged, tips, pairs);
  std::map<std::size_t, std::size_t> partners;  // how many a tip has
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (clear[i] == 0) continue;
    ++partners[pairs[i].first];
    ++partners[pairs[i].second];
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (clear[i] == 0) continue;
    const Tip &tip = tips[pairs[i].first], &other = tips[pairs[i].second];
    Rational size = squared_distance(tip.point, other.point);
    const LineId p = work.ending_at(tip.line, tip.point);
    const LineId q = work.ending_at(other.line, other.point);
    if (partners[pairs[i].first] > 1 || partners[pairs[i].second] > 1) {
      work.refuse(EditKind::Joint, tip.point, std::move(size),
                  "several loose ends face each other on parallel lines", {p, q});
      continue;
    }
    const Line line = work.line(p), second = work.line(q);
    Line joint{tip.point, other.point, united(line, second).segments};
    work.apply(EditKind::Joint, tip.point, std::move(size), {p, q}, {line, second, joint});
  }
}

}  // namespace plumbline::repair_steps

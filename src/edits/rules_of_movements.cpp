// Weld, Snap and Simplify: how far ends go in one edit. How far they go in all is the matter of
// `check_movement`.

#include <algorithm>
#include <map>

#include "edits/rules.hpp"
#include "geometry/union_find.hpp"

namespace plumbline::edits {
namespace {

/// Whether all ends of the lines are so near each other that one point is within the distance.
bool is_small(const std::vector<Segment>& segments, const Rational& limit) {
  return std::ranges::all_of(
      segments, [&](const Segment& s) { return squared_distance(s.a, s.b) <= 4 * limit * limit; });
}

/// Whether the lines hang together, end on line.
bool is_connected(const std::vector<Line>& lines) {
  const auto touch = [](const Line& l, const Line& m) {
    return on_segment(l.a, l.b, m.a) || on_segment(l.a, l.b, m.b);
  };
  UnionFind sets(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (sets.find(i) == sets.find(j)) continue;
      if (touch(lines[i], lines[j]) || touch(lines[j], lines[i])) sets.unite(i, j);
    }
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (sets.find(i) != 0) return false;
  }
  return true;
}

/// What moves goes no farther than the edit says, from where it was or from where it was authored.
std::string wrong_distance(const Edit& edit, const std::vector<Segment>& from) {
  const std::vector<Segment> after = extents_of(edit.after);
  const Rational most = farthest_end(after, from);
  if (most <= edit.squared_size) return "";
  return "moves an end by " + length_text(most) + ", not " + length_text(edit.squared_size);
}

std::string wrong_simplification(const Edit& edit) {
  if (edit.before.size() < 2 || edit.after.size() != 1) return "is not of lines that become one";
  const Line& line = edit.after.front();
  std::map<Point, std::size_t> ends;
  for (const Line& l : edit.before) ++ends[l.a], ++ends[l.b];
  std::vector<Point> tips;
  for (const auto& [p, times] : ends) {
    if (times == 1) tips.push_back(p);
    if (times > 2) return "is not of a chain";
  }
  if (tips.size() != 2 || tips[0] != line.a || tips[1] != line.b) return "moves the chain's ends";
  return "";
}

}  // namespace

std::string wrong_movement(const Edit& edit, const Tolerances& tolerances,
                           std::span<const Segment> origins) {
  const bool is_one = edit.kind == EditKind::Simplify || edit.before.size() == 1;
  if (!is_one) return "moves " + std::to_string(edit.before.size()) + " lines";
  const Rational limit = edit.kind == EditKind::Weld   ? Rational(2 * tolerances.weld)
                         : edit.kind == EditKind::Snap ? tolerances.snap
                                                       : tolerances.simplify;
  std::string wrong = beyond(edit.squared_size, limit);
  if (!wrong.empty()) return wrong;
  if (edit.kind == EditKind::Simplify) wrong = wrong_simplification(edit);
  if (!wrong.empty()) return wrong;
  std::vector<Segment> from = extents_of(edit.before);
  if (edit.after.empty()) {
    return is_small(from, limit) ? "" : "makes a point of a line that is longer than it goes";
  }
  if (!is_connected(edit.after)) return "tears a line apart";
  const Rational left = farthest_end(from, extents_of(edit.after));
  if (left > 4 * limit * limit) return "leaves an end behind by " + length_text(left);
  if (edit.kind == EditKind::Simplify && left > edit.squared_size) {
    return "leaves a vertex behind by " + length_text(left) + ", not " +
           length_text(edit.squared_size);
  }
  from.insert(from.end(), origins.begin(), origins.end());
  return wrong_distance(edit, from);
}

}  // namespace plumbline::edits

// Grow, Bridge, Joint and Door: what was there stays.

#include <algorithm>
#include <iterator>

#include "edits/rules.hpp"

namespace plumbline::edits {
namespace {

bool is_end(const Line& line, const Point& p) { return line.a == p || line.b == p; }

std::string wrong_size(const Rational& squared, const Edit& edit) {
  if (squared == edit.squared_size) return "";
  return "adds " + length_text(squared) + ", not " + length_text(edit.squared_size);
}

std::string wrong_growth(const Edit& edit) {
  if (edit.before.size() != 1 || edit.after.size() != 1) return "is not of one line";
  const Line &line = edit.before.front(), &grown = edit.after.front();
  if (!is_collinear(extent_of(line), extent_of(grown))) return "leaves its line";
  const bool is_at_a = line.b == grown.b && grown.a < line.a;
  const bool is_at_b = line.a == grown.a && line.b < grown.b;
  if (!is_at_a && !is_at_b) return "does not make a line longer at one end";
  if (edit.where != (is_at_a ? line.a : line.b)) return "is not at the end that grows";
  return wrong_size(is_at_a ? squared_distance(grown.a, line.a) : squared_distance(grown.b, line.b),
                    edit);
}

std::string wrong_bridge(const Edit& edit) {
  if (edit.before.size() != 2 || edit.after.empty() || edit.after.size() > 2) {
    return "is not of two lines";
  }
  const bool is_first = edit.before[0].a < edit.before[1].a;
  const Line &low = edit.before[is_first ? 0 : 1], &high = edit.before[is_first ? 1 : 0];
  if (!is_collinear(extent_of(low), extent_of(high))) return "is not of lines on one line";
  if (!(low.b < high.a)) return "has no gap";
  if (!on_segment(low.b, high.a, edit.where)) return "is not at its gap";
  std::vector<Line> after = edit.after;
  std::ranges::sort(after, [](const Line& l, const Line& m) { return l.a < m.a; });
  const bool is_whole = after.front().a == low.a && after.back().b == high.b;
  const bool is_met = after.size() == 1 ||
                      (after[0].b == after[1].a && on_segment(low.b, high.a, after[0].b) &&
                       after[0].segments == low.segments && after[1].segments == high.segments);
  const bool is_straight = is_collinear(extent_of(low), extent_of(after.front())) &&
                           is_collinear(extent_of(low), extent_of(after.back()));
  if (!is_whole || !is_met || !is_straight) return "does not close its gap, and that alone";
  return wrong_size(squared_distance(low.b, high.a), edit);
}

std::string wrong_joint(const Edit& edit) {
  if (edit.before.size() != 2 || edit.after.size() != 3) return "is not of two lines";
  std::vector<Line> rest = edit.after;
  for (const Line& line : edit.before) {
    const auto place = std::ranges::find(rest, line);
    if (place == rest.end()) return "changes a line that it joins";
    rest.erase(place);
  }
  const Line &l = edit.before[0], &m = edit.before[1], &joint = rest.front();
  const bool is_between =
      (is_end(l, joint.a) && is_end(m, joint.b)) || (is_end(m, joint.a) && is_end(l, joint.b));
  if (!is_between) return "is not between two ends";
  const Rational turn = (l.b.x - l.a.x) * (m.b.y - m.a.y) - (l.b.y - l.a.y) * (m.b.x - m.a.x);
  if (turn != 0) return "is not of parallel lines";
  if (joint.segments != segments_of(edit.before)) return "stands for other segments";
  if (!is_end(joint, edit.where)) return "is not at one of its ends";
  return wrong_size(squared_distance(joint.a, joint.b), edit);
}

std::string wrong_door(const Edit& edit, const Tolerances& tolerances) {
  if (!edit.before.empty()) return "takes lines away";
  if (edit.after.empty() || edit.after.size() > 2) return "is not of one or two lines";
  if (!tolerances.doors) return "is one where doors are not asked for";
  // Two sides of an opening are of one width and parallel, but for rounding of the drawing.
  constexpr int kRounding = 1000000;
  const Line &l = edit.after.front(), &m = edit.after.back();
  Rational least = squared_distance(l.a, l.b);
  for (const Line& line : edit.after) {
    if (!line.segments.empty()) return "is not virtual";
    least = std::min(least, squared_distance(line.a, line.b));
  }
  std::string wrong = wrong_size(least, edit);
  if (!wrong.empty()) return wrong;
  const Rational x = (l.b.x - l.a.x) - (m.b.x - m.a.x), y = (l.b.y - l.a.y) - (m.b.y - m.a.y);
  if ((x * x + y * y) * kRounding * kRounding > least) return "has sides that are not parallel";
  const Range& widths = *tolerances.doors;
  const bool is_wide = widths.least * widths.least <= edit.squared_size &&
                       edit.squared_size <= widths.most * widths.most;
  return is_wide ? "" : "is " + length_text(edit.squared_size) + " wide, which no door is";
}

}  // namespace

std::string beyond(const Rational& squared, const Rational& limit) {
  if (sgn(limit) >= 0 && squared <= limit * limit) return "";
  return "goes " + length_text(squared) + ", more than " + exact_text(limit);
}

std::string wrong_addition(const Edit& edit, const Tolerances& tolerances) {
  if (edit.kind == EditKind::Door) return wrong_door(edit, tolerances);
  std::string wrong = edit.kind == EditKind::Grow     ? wrong_growth(edit)
                      : edit.kind == EditKind::Bridge ? wrong_bridge(edit)
                                                      : wrong_joint(edit);
  return wrong.empty() ? beyond(edit.squared_size, tolerances.grow) : wrong;
}

std::vector<Segment> added(const Edit& edit) {
  return without(extents_of(edit.after), edit.before);
}

}  // namespace plumbline::edits

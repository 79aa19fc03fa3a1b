// Trim and Sliver: what stays of a line is a part of it.

#include <algorithm>
#include <map>

#include "edits/rules.hpp"

namespace plumbline::edits {
namespace {

bool is_part(const Line& part, std::span<const Line> lines) {
  return std::ranges::any_of(lines, [&](const Line& line) {
    return line.segments == part.segments && covers(extent_of(line), extent_of(part));
  });
}

/// Whether the segments hang together by their ends, and with the point.
bool hang_together(const Point& start, std::span<const Segment> segments) {
  std::map<Point, std::vector<Point>> next;
  for (const Segment& s : segments) {
    next[s.a].push_back(s.b);
    next[s.b].push_back(s.a);
  }
  std::vector<Point> reached = {start};
  while (!reached.empty()) {
    const auto place = next.find(reached.back());
    reached.pop_back();
    if (place == next.end()) continue;
    reached.insert(reached.end(), place->second.begin(), place->second.end());
    next.erase(place);
  }
  return next.empty();
}

std::string wrong_reach(const Edit& edit, const std::vector<Segment>& gone) {
  if (!hang_together(edit.where, gone)) return "takes what is no chain from its junction";
  Rational reach = 0;
  for (const Segment& s : gone) {
    reach = std::max({reach, squared_distance(edit.where, s.a), squared_distance(edit.where, s.b)});
  }
  if (reach == edit.squared_size) return "";
  return "reaches " + length_text(reach) + ", not " + length_text(edit.squared_size);
}

}  // namespace

std::string wrong_removal(const Edit& edit, const Tolerances& tolerances) {
  const auto is_kept = [&](const Line& line) { return is_part(line, edit.before); };
  if (!std::ranges::all_of(edit.after, is_kept)) return "leaves what was not there";
  const std::vector<Segment> gone = without(extents_of(edit.before), edit.after);
  if (gone.empty()) return "takes nothing away";
  const bool is_trim = edit.kind == EditKind::Trim;
  std::string wrong = is_trim ? wrong_reach(edit, gone) : "";
  if (!wrong.empty()) return wrong;
  return beyond(edit.squared_size, is_trim ? tolerances.trim : tolerances.sliver);
}

}  // namespace plumbline::edits

// Vertices that edits have left with two lines that end there, on one line and on both sides of it.

#include <algorithm>
#include <array>
#include <set>

#include "geometry/box_tree.hpp"
#include "repair/steps.hpp"

namespace plumbline::repair_steps {
namespace {

/// Where edits have taken lines away, cut them, or let them end: all ends of their lines.
std::set<Point> touched(const std::vector<Edit>& edits, std::size_t first_edit) {
  std::set<Point> result;
  for (std::size_t i = first_edit; i < edits.size(); ++i) {
    if (edits[i].kind == EditKind::Merge) continue;  // which takes nothing away
    result.insert(edits[i].where);
    for (const auto* lines : {&edits[i].before, &edits[i].after}) {
      for (const Line& line : *lines) {
        result.insert(line.a);
        result.insert(line.b);
      }
    }
  }
  return result;
}

/// Per point, the lines that have it.
std::vector<std::vector<LineId>> lines_at(const Work& work, const std::vector<Point>& points) {
  std::vector<BoxD> boxes;
  for (const Point& p : points) {
    const PointD rounded = nearest(p);
    const std::array corner = {rounded};
    boxes.push_back(grown({rounded, rounded}, largest_coordinate(corner) * 0x1p-40));
  }
  const BoxTree tree(boxes);
  std::vector<std::vector<LineId>> result(points.size());
  for (const LineId id : work.lines()) {
    for (const std::size_t i : tree.meeting(work.rounded(id))) {
      const Line line = work.line(id);
      if (on_segment(line.a, line.b, points[i])) result[i].push_back(id);
    }
  }
  return result;
}

}  // namespace

void dissolve(Work& work, std::size_t first_edit) {
  if (work.edits().size() == first_edit) return;
  const std::set<Point> candidates = touched(work.edits(), first_edit);
  const std::vector<Point> points(candidates.begin(), candidates.end());
  const std::vector<std::vector<LineId>> at = lines_at(work, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (at[i].size() != 2) continue;
    const Point& p = points[i];
    if (!work.is_end(at[i][0], p) || !work.is_end(at[i][1], p)) continue;
    const LineId first = work.ending_at(at[i][0], p), second = work.ending_at(at[i][1], p);
    if (work.is_anchored(first) || work.is_anchored(second) || !work.is_same_layer(first, second)) {
      continue;
    }
    const Line line = work.line(first), other = work.line(second);
    const bool are_end_to_end = (line.b == p && other.a == p) || (other.b == p && line.a == p);
    const Line whole = united(line, other);
    if (!are_end_to_end || orientation(whole.a, p, whole.b) != 0) continue;
    work.apply(EditKind::Dissolve, p, 0, {first, second}, {whole});
  }
}

}  // namespace plumbline::repair_steps

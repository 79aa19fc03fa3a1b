#include <algorithm>
#include <set>

#include "edits/rules.hpp"
#include "edits/steps.hpp"

namespace plumbline::edits {
namespace {

std::vector<Segment> authored(const SegmentSet& input, std::span<const Line> lines) {
  std::vector<Segment> result;
  for (const SegmentId s : segments_of(lines)) result.push_back(ordered(input.segments[s]));
  return result;
}

std::string wrong_for_kind(const SegmentSet& input, const Edit& edit,
                           const Tolerances& tolerances) {
  switch (edit.kind) {
    case EditKind::Merge:
    case EditKind::Dissolve:
      return wrong_union(edit);
    case EditKind::Grow:
    case EditKind::Bridge:
    case EditKind::Joint:
    case EditKind::Door:
      return wrong_addition(edit, tolerances);
    case EditKind::Trim:
    case EditKind::Sliver:
      return wrong_removal(edit, tolerances);
    default:
      return wrong_movement(edit, tolerances, authored(input, edit.before));
  }
}

bool may_drop(EditKind kind) {
  return kind == EditKind::Trim || kind == EditKind::Sliver || kind == EditKind::Weld ||
         kind == EditKind::Snap;
}

bool is_virtual(const Line& line) { return line.segments.empty(); }

std::string wrong_segments(const Edit& edit, const std::vector<SegmentId>& anchored) {
  const std::vector<SegmentId> before = segments_of(edit.before), after = segments_of(edit.after);
  if (share_segment(before, anchored)) return "changes an anchored segment";
  const bool is_door = edit.kind == EditKind::Door;
  if (!is_door && (std::ranges::any_of(edit.before, is_virtual) ||
                   std::ranges::any_of(edit.after, is_virtual))) {
    return "has a virtual line";
  }
  if (may_drop(edit.kind) ? std::ranges::includes(before, after) : before == after) return "";
  return "takes lines of " + std::to_string(before.size()) + " segments and puts lines of " +
         std::to_string(after.size()) + ", or of others";
}

}  // namespace

std::vector<Breach> check_rules(const SegmentSet& input, const Repair& repair) {
  std::vector<Breach> result;
  std::set<std::pair<Point, std::vector<SegmentId>>> tips;  // of what has grown
  for (std::size_t t = 0; t < repair.edits.size(); ++t) {
    const Edit& edit = repair.edits[t];
    std::string wrong = wrong_segments(edit, repair.anchored);
    if (wrong.empty()) wrong = wrong_for_kind(input, edit, repair.tolerances);
    if (wrong.empty() && edit.kind == EditKind::Grow) {
      const Segment piece = added(edit).front();
      const std::vector<SegmentId>& ids = edit.after.front().segments;
      if (tips.contains({edit.where, ids})) wrong = "goes on where it ended before";
      tips.insert({piece.a == edit.where ? piece.b : piece.a, ids});
    }
    if (!wrong.empty()) result.push_back({to_text(edit.kind) + " " + wrong, edit.where, t});
  }
  return result;
}

}  // namespace plumbline::edits

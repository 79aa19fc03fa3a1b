#include "edits/moves.hpp"

#include <algorithm>

#include "edits/rules.hpp"

namespace plumbline::edits {

// What a line becomes stands for all of its segments: the first one of them leads to it.
Moves::Moves(const Repair& repair) : tolerances_(repair.tolerances) {
  for (const Edit& edit : repair.edits) {
    switch (edit.kind) {
      case EditKind::Grow:
      case EditKind::Bridge:
      case EditKind::Joint:
        for (const Segment& piece : added(edit)) {
          for (const Line& line : edit.after) {
            if (covers(extent_of(line), piece)) added_.emplace(line.segments.front(), piece);
          }
        }
        break;
      case EditKind::Weld:
      case EditKind::Snap:
      case EditKind::Simplify:
        for (const Line& line : edit.before) {
          std::vector<EditKind>& kinds = kinds_[line.segments.front()];
          if (std::ranges::find(kinds, edit.kind) == kinds.end()) kinds.push_back(edit.kind);
        }
        break;
      default:
        break;
    }
  }
}

bool Moves::is_moved(std::span<const SegmentId> segments) const {
  return std::ranges::any_of(segments, [&](SegmentId s) { return kinds_.contains(s); });
}

bool Moves::is_snapped(std::span<const SegmentId> segments) const {
  return std::ranges::any_of(segments, [&](SegmentId s) {
    const auto place = kinds_.find(s);
    return place != kinds_.end() && std::ranges::count(place->second, EditKind::Snap) > 0;
  });
}

Rational Moves::bound(std::span<const SegmentId> segments) const {
  bool is_welded = false, is_snapped = false, is_simplified = false;
  for (const SegmentId s : segments) {
    const auto place = kinds_.find(s);
    if (place == kinds_.end()) continue;
    for (const EditKind kind : place->second) {
      is_welded = is_welded || kind == EditKind::Weld;
      is_snapped = is_snapped || kind == EditKind::Snap;
      is_simplified = is_simplified || kind == EditKind::Simplify;
    }
  }
  Rational result = 0;
  if (is_welded) result += 2 * tolerances_.weld;
  if (is_snapped) result += 2 * tolerances_.snap;
  if (is_simplified) result += tolerances_.simplify;
  return result;
}

std::vector<Segment> Moves::added_to(std::span<const SegmentId> segments) const {
  std::vector<Segment> result;
  for (const SegmentId s : segments) {
    const auto [first, last] = added_.equal_range(s);
    for (auto place = first; place != last; ++place) result.push_back(place->second);
  }
  return result;
}

}  // namespace plumbline::edits

// Merge and Dissolve: lines on one line become one, and no point of them goes or comes.

#include <algorithm>

#include "edits/rules.hpp"

namespace plumbline::edits {

std::string wrong_union(const Edit& edit) {
  if (edit.squared_size != 0) return "moves something";
  if (edit.before.size() < 2 || edit.after.size() != 1) {
    return "makes " + std::to_string(edit.after.size()) + " lines of " +
           std::to_string(edit.before.size());
  }
  std::vector<Segment> parts = extents_of(edit.before);
  const Segment whole = extent_of(edit.after.front());
  const auto is_on = [&](const Segment& part) { return is_collinear(whole, part); };
  if (!std::ranges::all_of(parts, is_on)) return "takes lines that are not on one line";
  std::ranges::sort(parts, [](const Segment& s, const Segment& t) { return s.a < t.a; });
  Point end = parts.front().b;
  for (const Segment& part : std::span(parts).subspan(1)) {
    const bool is_right = edit.kind == EditKind::Merge ? part.a < end : part.a == end;
    if (!is_right) {
      return edit.kind == EditKind::Merge ? "takes lines that do not overlap"
                                          : "takes lines that are not end to end";
    }
    end = std::max(end, part.b);
  }
  if (parts.front().a != whole.a || end != whole.b) return "makes a line that is not their union";
  return "";
}

}  // namespace plumbline::edits

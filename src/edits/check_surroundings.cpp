// Additions start at loose ends, run over what is free and end on something; doors are between
// ends; what is dissolved was a meeting of nothing else; what is trimmed hung by its junction
// alone; a thin border went to one that is near.

#include <algorithm>
#include <iterator>

#include "edits/rules.hpp"
#include "edits/steps.hpp"

namespace plumbline::edits {
namespace {

bool grows(EditKind kind) {
  return kind == EditKind::Grow || kind == EditKind::Bridge || kind == EditKind::Joint;
}

class Surroundings {
 public:
  Surroundings(const SegmentSet& input, const Repair& repair, const Replay& replay)
      : edits_(repair.edits), drawing_(input, replay) {}

  /// Loose ends grow at the same time: `start` is the state before all that grow together.
  std::string wrong(std::size_t t, std::size_t start) const {
    switch (edits_[t].kind) {
      case EditKind::Grow:
      case EditKind::Bridge:
      case EditKind::Joint:
        return wrong_growth(t, start);
      case EditKind::Door:
        return wrong_door(t);
      case EditKind::Dissolve:
        return wrong_dissolution(t);
      case EditKind::Trim:
        return wrong_trim(t);
      case EditKind::Sliver:
        return wrong_sliver(t);
      default:
        return "";
    }
  }

 private:
  /// Other lines than those of the edit, and parts of them, that have the point.
  std::vector<Line> others_at(const Point& p, const Edit& edit, std::size_t first,
                              std::size_t last) const {
    std::vector<Line> result = drawing_.at(p, first, last);
    std::erase_if(result, [&](const Line& line) { return is_own(line, edit); });
    return result;
  }

  static bool is_own(const Line& line, const Edit& edit) {
    return std::ranges::any_of(edit.before, [&](const Line& own) {
      return share_segment(line.segments, own.segments) &&
             is_collinear(extent_of(line), extent_of(own));
    });
  }

  /// Whether all other lines at the end of a line end there, too, and lie over it.
  bool is_loose(const Point& p, const Segment& line, const Edit& edit, std::size_t state) const {
    const std::vector<Line> others = others_at(p, edit, state, state);
    return std::ranges::all_of(others, [&](const Line& other) {
      return (other.a == p || other.b == p) && is_collinear(line, extent_of(other)) &&
             meets_inside(line, extent_of(other));
    });
  }

  std::string wrong_growth(std::size_t t, std::size_t start) const {
    const Edit& edit = edits_[t];
    const std::vector<Segment> pieces = added(edit);
    for (const Segment& piece : pieces) {
      for (const Point& p : {piece.a, piece.b}) {
        const auto own = std::ranges::find_if(
            edit.before, [&](const Line& line) { return line.a == p || line.b == p; });
        const bool is_loose_end = own != edit.before.end();
        if (is_loose_end && !is_loose(p, extent_of(*own), edit, start)) {
          return "starts at an end that is not loose";
        }
        if (edit.kind == EditKind::Grow && !is_loose_end &&
            others_at(p, edit, start, edits_.size()).empty()) {
          return "ends on nothing";
        }
      }
      if (passes_meeting(piece, edit, start)) return "goes past what it meets first";
    }
    return "";
  }

  /// Whether other lines meet a piece between its ends. The ends of a bridge may come from both
  /// sides to one point of them.
  bool passes_meeting(const Segment& piece, const Edit& edit, std::size_t state) const {
    std::optional<Point> first;
    for (const Line& line : drawing_.around(piece, state, state)) {
      if (is_own(line, edit) || !meets_inside(piece, extent_of(line))) continue;
      const std::optional<Point> meeting = crossing(piece, extent_of(line));
      if (edit.kind != EditKind::Bridge || !meeting || (first && *first != *meeting)) return true;
      first = meeting;
    }
    return false;
  }

  std::string wrong_door(std::size_t t) const {
    for (const Line& side : edits_[t].after) {
      if (!is_vertex(side.a, t) || !is_vertex(side.b, t)) return "is not between ends of walls";
    }
    return "";
  }

  /// Whether a line ends at the point, or two cross there.
  bool is_vertex(const Point& p, std::size_t state) const {
    const std::vector<Line> lines = drawing_.at(p, state, state);
    return std::ranges::any_of(lines, [&](const Line& line) {
      return line.a == p || line.b == p || !is_collinear(extent_of(line), extent_of(lines.front()));
    });
  }

  std::string wrong_dissolution(std::size_t t) const {
    const Edit& edit = edits_[t];
    const Line& whole = edit.after.front();
    for (const Line& part : edit.before) {
      if (part.b == whole.b) continue;
      for (const Line& line : drawing_.at(part.b, t, t)) {
        if (std::ranges::find(edit.before, line) == edit.before.end()) {
          return "is where another line is";
        }
      }
    }
    return "";
  }

  /// Nothing that stays touches what went but at the junction, where something does.
  std::string wrong_trim(std::size_t t) const {
    const Edit& edit = edits_[t];
    for (const Segment& piece : without(extents_of(edit.before), edit.after)) {
      for (const Point& p : {piece.a, piece.b}) {
        if (p != edit.where && !drawing_.at(p, t + 1, t + 1).empty()) {
          return "takes what is not loose";
        }
      }
      for (const Line& line : drawing_.around(piece, t + 1, t + 1)) {
        if (meets_inside(piece, extent_of(line))) return "takes what is not loose";
      }
    }
    return drawing_.at(edit.where, t + 1, t + 1).empty() ? "takes a whole free piece" : "";
  }

  /// All of what went has something that stays within its size at its ends, and within twice that
  /// between.
  std::string wrong_sliver(std::size_t t) const {
    const Edit& edit = edits_[t];
    for (const Segment& piece : without(extents_of(edit.before), edit.after)) {
      const bool is_near = !near(piece.a, edit.squared_size, t + 1).empty() &&
                           !near(piece.b, edit.squared_size, t + 1).empty() &&
                           is_near_along(piece, 4 * edit.squared_size, t + 1, kMostHalvings);
      if (is_near) continue;
      return "takes a border that is farther from what stays than " +
             length_text(edit.squared_size);
    }
    return "";
  }

  /// The lines that are not farther from the point.
  std::vector<Line> near(const Point& p, const Rational& squared, std::size_t state) const {
    std::vector<Line> result =
        drawing_.near(p, rational_from(nearest_sqrt(squared) * kRoom), state);
    std::erase_if(result,
                  [&](const Line& line) { return squared_distance(p, line.a, line.b) > squared; });
    return result;
  }

  /// A line that is near both ends of a piece is near all of it; other pieces are halved.
  bool is_near_along(const Segment& piece, const Rational& squared, std::size_t state,
                     int halvings) const {
    const std::vector<Line> lines = near(piece.a, squared, state);
    const auto is_beside = [&](const Line& line) {
      return squared_distance(piece.b, line.a, line.b) <= squared;
    };
    if (std::ranges::any_of(lines, is_beside)) return true;
    if (lines.empty() || halvings == 0) return false;
    const Point middle = {(piece.a.x + piece.b.x) / 2, (piece.a.y + piece.b.y) / 2};
    return !near(middle, squared, state).empty() &&
           is_near_along({piece.a, middle}, squared, state, halvings - 1) &&
           is_near_along({middle, piece.b}, squared, state, halvings - 1);
  }

  /// So often that pieces are shorter than any sliver is wide.
  static constexpr int kMostHalvings = 40;
  /// More than roots are off by.
  static constexpr double kRoom = 1 + 0x1p-40;

  const std::vector<Edit>& edits_;
  const Drawing drawing_;
};

}  // namespace

std::vector<Breach> check_surroundings(const SegmentSet& input, const Repair& repair,
                                       const Replay& replay) {
  std::vector<Breach> result;
  if (repair.edits.empty()) return result;
  const Surroundings surroundings(input, repair, replay);
  std::size_t start = 0;
  for (std::size_t t = 0; t < repair.edits.size(); ++t) {
    const Edit& edit = repair.edits[t];
    if (t == 0 || !grows(edit.kind) || !grows(repair.edits[t - 1].kind)) start = t;
    const std::string wrong = surroundings.wrong(t, start);
    if (!wrong.empty()) result.push_back({to_text(edit.kind) + " " + wrong, edit.where, t});
  }
  return result;
}

}  // namespace plumbline::edits

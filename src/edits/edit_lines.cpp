#include "edits/edit_lines.hpp"

#include <algorithm>

#include "geometry/box_tree.hpp"

namespace plumbline::edits {

struct EditLines::Tree {
  /// A part of a line that an edit drew, or took away.
  struct Piece {
    Segment segment;
    std::size_t edit;
    bool is_drawn;
  };

  explicit Tree(const std::vector<Edit>& edits)
      : pieces(pieces_of(edits)), boxes(boxes_of(pieces)) {}

  static std::vector<Piece> pieces_of(const std::vector<Edit>& edits) {
    std::vector<Piece> result;
    for (std::size_t t = 0; t < edits.size(); ++t) {
      const Edit& edit = edits[t];
      for (Segment& s : without(extents_of(edit.after), edit.before)) {
        result.push_back({std::move(s), t, true});
      }
      for (Segment& s : without(extents_of(edit.before), edit.after)) {
        result.push_back({std::move(s), t, false});
      }
    }
    return result;
  }

  static std::vector<BoxD> boxes_of(const std::vector<Piece>& pieces) {
    std::vector<BoxD> result;
    for (const Piece& piece : pieces) {
      const PointD ends[] = {nearest(piece.segment.a), nearest(piece.segment.b)};
      result.push_back(box_of(ends));
    }
    return result;
  }

  std::vector<Piece> pieces;
  BoxTree boxes;
};

EditLines::EditLines(const std::vector<Edit>& edits) : tree_(std::make_unique<Tree>(edits)) {}
EditLines::~EditLines() = default;

std::vector<std::size_t> EditLines::that_changed(const Segment& s, bool is_drawn) const {
  const PointD middle = nearest(Point{(s.a.x + s.b.x) / 2, (s.a.y + s.b.y) / 2});
  std::vector<std::size_t> result;
  for (const std::size_t i : tree_->boxes.meeting(BoxD{middle, middle})) {
    const Tree::Piece& piece = tree_->pieces[i];
    if (piece.is_drawn == is_drawn && covers(piece.segment, s)) result.push_back(piece.edit);
  }
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace plumbline::edits

#include "edits/edit_lines.hpp"

#include <array>
#include <map>

#include "geometry/box_tree.hpp"

namespace plumbline::edits {

struct EditLines::Tree {
  struct EditLine {
    const Line* line;
    std::size_t edit;
    bool is_after;
  };

  explicit Tree(const std::vector<Edit>& edits) : lines(lines_of(edits)), boxes(boxes_of(lines)) {}

  static std::vector<EditLine> lines_of(const std::vector<Edit>& edits) {
    std::vector<EditLine> result;
    for (std::size_t t = 0; t < edits.size(); ++t) {
      for (const Line& line : edits[t].before) result.push_back({&line, t, false});
      for (const Line& line : edits[t].after) result.push_back({&line, t, true});
    }
    return result;
  }

  static std::vector<BoxD> boxes_of(const std::vector<EditLine>& lines) {
    std::vector<BoxD> result;
    for (const EditLine& line : lines) {
      const PointD ends[] = {nearest(line.line->a), nearest(line.line->b)};
      result.push_back(box_of(ends));
    }
    return result;
  }

  std::vector<EditLine> lines;
  BoxTree boxes;
};

EditLines::EditLines(const std::vector<Edit>& edits) : tree_(std::make_unique<Tree>(edits)) {}
EditLines::~EditLines() = default;

std::vector<std::size_t> EditLines::that_changed(const Segment& s, bool is_drawn) const {
  std::map<std::size_t, std::array<bool, 2>> is_covered;  // by lines before, by lines after
  const PointD middle = nearest(Point{(s.a.x + s.b.x) / 2, (s.a.y + s.b.y) / 2});
  for (const std::size_t i : tree_->boxes.meeting(BoxD{middle, middle})) {
    const Tree::EditLine& line = tree_->lines[i];
    if (!covers(extent_of(*line.line), s)) continue;
    is_covered.try_emplace(line.edit).first->second[line.is_after ? 1 : 0] = true;
  }
  std::vector<std::size_t> result;
  for (const auto& [edit, by] : is_covered) {
    if (by[is_drawn ? 1 : 0] && !by[is_drawn ? 0 : 1]) result.push_back(edit);
  }
  return result;
}

}  // namespace plumbline::edits

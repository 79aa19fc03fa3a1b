#pragma once

#include <memory>
#include <vector>

#include "edits/lines.hpp"

namespace plumbline::edits {

/// Which edits drew what, or took it away.
class EditLines {
 public:
  explicit EditLines(const std::vector<Edit>& edits);
  EditLines(const EditLines&) = delete;
  EditLines& operator=(const EditLines&) = delete;
  ~EditLines();

  /// The edits whose lines after cover the segment and whose lines before do not; or the other way
  /// round. Ascending. Requires: no end of a line of an edit lies strictly inside the segment.
  std::vector<std::size_t> that_drew(const Segment& s) const { return that_changed(s, true); }
  std::vector<std::size_t> that_removed(const Segment& s) const { return that_changed(s, false); }

 private:
  struct Tree;
  std::vector<std::size_t> that_changed(const Segment& s, bool is_drawn) const;

  std::unique_ptr<Tree> tree_;
};

}  // namespace plumbline::edits

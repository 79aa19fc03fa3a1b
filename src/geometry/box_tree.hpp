#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geometry/point_d.hpp"

namespace plumbline {

/// Boxes in an R-tree, for the question which of them something meets. **Rounded**: give boxes some
/// room. Answers are indices of boxes, ascending. Requires: finite coordinates. Cost: O(n log n) to
/// build, O(log n) a query and what it finds.
class BoxTree {
 public:
  explicit BoxTree(std::span<const BoxD> boxes);
  BoxTree(const BoxTree&) = delete;
  BoxTree& operator=(const BoxTree&) = delete;
  ~BoxTree();

  std::vector<std::size_t> meeting(const SegmentD& s) const;
  std::vector<std::size_t> meeting(const BoxD& box) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// The box grown by this much on each side.
inline BoxD grown(const BoxD& box, double by) {
  return {{box.low.x - by, box.low.y - by}, {box.high.x + by, box.high.y + by}};
}

}  // namespace plumbline

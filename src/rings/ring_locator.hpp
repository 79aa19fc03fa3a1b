#pragma once

#include <vector>

#include "geometry/box_tree.hpp"
#include "rings/walk.hpp"

namespace plumbline::rings {

/// Tells what lies within a closed ring that does not cross itself.
class RingLocator {
 public:
  /// Keeps references.
  RingLocator(const SegmentSet& input, const ExactComplex& complex, const Walk& walk);

  /// Whether the point is inside. Requires: it is not on the ring. **Exact**. Cost: O(log n) and
  /// the segments to the right of the point.
  bool contains(const Point& p) const;
  const BoxD& box() const { return box_; }
  /// A point of the other ring that is not on this one; none where it runs along this one wholly.
  std::optional<Point> point_off(const Walk& other) const;

 private:
  const SegmentSet& input_;
  const ExactComplex& complex_;
  const Walk& walk_;
  std::vector<VertexId> vertices_;  ///< ascending
  std::vector<EdgeId> edges_;       ///< ascending
  BoxD box_;                        ///< with some room
  std::unique_ptr<BoxTree> sides_;
};

}  // namespace plumbline::rings

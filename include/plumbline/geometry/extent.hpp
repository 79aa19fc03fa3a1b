#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// Where a drawing is: the box of its segments without those that are stray.
struct Extent {
  PointD low, high;
  /// Positions of the stray segments, ascending.
  std::vector<std::size_t> stray;
  /// The nearest stray segment is so many of the box's longer sides away from the middle.
  double sizes_away = 0;

  double longer_side() const { return std::max(high.x - low.x, high.y - low.y); }
};

/// A segment is stray where it is further than this many sizes of the drawing from its middle.
inline constexpr double kStraySizes = 20;

/// The middle is the box from the first to the third quartile of the segments' midpoints, in x and
/// in y. From there outwards segments join the drawing; the first one that is further from the
/// middle than kStraySizes times the longer side of what has joined, and than it is long, is stray,
/// and so is all beyond. Where that would be more than a quarter of the segments, none is stray.
/// **Rounded**. Degenerate: (0, 0) for no segments. The box does not depend on the segments' order.
Extent extent(std::span<const SegmentD> segments);
Extent extent(const SegmentSet& input);

}  // namespace plumbline

#pragma once

// How a full bucket is split.

#include <span>
#include <vector>

#include "arrange/bucket/lines.hpp"
#include "arrange/bucket/types.hpp"

namespace plumbline::bucket {

/// A bucket with more lines is full.
inline constexpr std::size_t kFullBucket = 24;

/// The part of a line in a bucket, from one parameter to another.
struct Piece {
  LineId line;
  double from, to;
};

/// The pieces of a bucket on both sides of the line where normal . p = at; those near it are on
/// both.
struct Split {
  bool useful = false;
  PointD normal;
  double at = 0;
  std::vector<Piece> low, high;
};

/// The best split at the centroid: along x, along y, across the lines' common direction or one of
/// two that they have, or along their ends. Not useful if there are few lines, if all but a few go
/// through one point (a pencil is searched best as a whole), or if too many lines would be on both
/// sides.
Split split(const std::vector<Piece>& members, std::span<const Approx> lines, const Margin& margin);

/// The unit vector across the mean direction of lines.
PointD mean_normal(std::span<const LineId> members, std::span<const Approx> lines);

/// The part of a line within a box, widened by `slack`; the whole line where rounding leaves
/// nothing.
Piece clipped(LineId line, std::span<const Approx> lines, const Box& box, double slack);
/// Its ends.
std::pair<PointD, PointD> ends_of(const Piece& piece, std::span<const Approx> lines);

}  // namespace plumbline::bucket

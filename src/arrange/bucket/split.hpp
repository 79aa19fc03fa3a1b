#pragma once

// How a full bucket is split.

#include <span>
#include <vector>

#include "arrange/bucket/lines.hpp"
#include "arrange/bucket/types.hpp"

namespace plumbline::bucket {

/// A bucket with more lines is full.
inline constexpr std::size_t kFullBucket = 24;

/// The lines of a bucket on both sides of the line where normal . p = at; those near it are on
/// both.
struct Split {
  bool useful = false;
  PointD normal;
  double at = 0;
  std::vector<LineId> low, high;
  Box low_box{}, high_box{};

  std::size_t size() const { return low.size() + high.size(); }
};

/// The best split at the centroid: along x, along y, or across the lines' common direction. Not
/// useful if there are few lines, if all but a few go through one point (a pencil is searched best
/// as a whole), or if too many lines would be on both sides.
Split split(const Box& box, const std::vector<LineId>& members, std::span<const Approx> lines,
            const Margin& margin);

/// The unit vector across the mean direction of lines, and how much they agree in it (0 to 1).
struct MeanNormal {
  PointD normal;
  double agreement;
};
MeanNormal mean_normal(std::span<const LineId> members, std::span<const Approx> lines);

/// The ends of the part of a line within a box, widened by `slack`; the whole line where rounding
/// leaves nothing.
std::pair<PointD, PointD> clipped(const Approx& line, const Box& box, double slack);

}  // namespace plumbline::bucket

#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "plumbline/geometry/point_list.hpp"

namespace plumbline {

/// Exact points beside their coordinates in doubles: predicates look at the doubles first and at
/// the exact coordinates only where rounding could matter. All answers are **exact**.
class FilteredPoints {
 public:
  /// Keeps a reference to the points.
  explicit FilteredPoints(const PointList& points);

  Point operator[](std::size_t p) const { return points_[p]; }
  /// Each coordinate within `error()` of the exact one, in the exact order or equal where that is
  /// not. Not finite beyond the largest double.
  const PointD& rough(std::size_t p) const { return rough_[p]; }
  double error() const { return error_; }
  std::size_t size() const { return rough_.size(); }

  /// The points themselves.
  const PointList& list() const { return points_; }

  /// -1, 0, +1: r lies right of, on, left of the line from p to q.
  int orientation(std::size_t p, std::size_t q, std::size_t r) const {
    const PointD &a = rough_[p], &b = rough_[q], &c = rough_[r];
    const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
    const double left = ux * vy, right = uy * vx, det = left - right;
    // Each difference is off by at most d = 4 error_ (two errors of coordinates; its rounding is
    // at most 2^-52 times the largest coordinate, half of error_), so each product by
    // d (|u| + |v|) + d^2 and its rounding, 2^-53 of it; twice that covers the rounding of `bound`.
    const double d = 4 * error_;
    const double bound =
        2 * (d * (std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy) + 2 * d) +
             0x1p-52 * (std::abs(left) + std::abs(right))) +
        kUnderflow;
    if (det > bound) return 1;
    if (det < -bound) return -1;
    return exact_orientation(p, q, r);  // also where something is not finite
  }
  /// Lexicographic by (x, y).
  bool is_before(std::size_t p, std::size_t q) const {
    const PointD &a = rough_[p], &b = rough_[q];
    return a.x != b.x ? a.x < b.x : points_.compare(p, q) < 0;
  }

 private:
  static constexpr double kUnderflow = 0x1p-1000;  // far more than what products lose below 2^-1022

  int exact_orientation(std::size_t p, std::size_t q, std::size_t r) const;

  const PointList& points_;
  std::vector<PointD> rough_;
  double error_ = 0;
};

}  // namespace plumbline

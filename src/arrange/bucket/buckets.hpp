#pragma once

// Step 3: the plane divided into buckets.

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "arrange/bucket/job.hpp"
#include "arrange/bucket/lines.hpp"
#include "arrange/bucket/types.hpp"

namespace plumbline::bucket {

struct Piece;
struct Split;

/// The x coordinates that a line takes at heights within a range, widened by the margin.
class Band {
 public:
  Band(const Approx& l, double margin)
      : l_(l),
        margin_(margin),
        bottom_(std::min(l.ay, l.by)),
        top_(std::max(l.ay, l.by)),
        slope_((l.bx - l.ax) / (l.by - l.ay)) {}

  std::pair<double, double> between(double low, double high) const {
    // All but level: a slope that is no number.
    if (!(bottom_ < top_) || !std::isfinite(slope_)) return {l_.ax - margin_, l_.bx + margin_};
    double x0 = at(low - margin_), x1 = at(high + margin_);
    if (x1 < x0) std::swap(x0, x1);
    // A steep slope magnifies rounding; the line has no other x.
    return {std::clamp(x0, l_.ax, l_.bx) - margin_, std::clamp(x1, l_.ax, l_.bx) + margin_};
  }

 private:
  double at(double y) const { return l_.ax + (std::clamp(y, bottom_, top_) - l_.ay) * slope_; }

  const Approx& l_;
  double margin_, bottom_, top_, slope_;
};

/// The plane divided into parts ("buckets"), each with the lines that cross it: a uniform grid
/// whose full cells are split further at the centroid, along x, y or across the lines' common
/// direction (the idea of LAR's buckets: inters, 2.1). Every point belongs to one bucket. A bucket
/// lists each line that comes within its own margin of it, so a point that is known only to within
/// the margin of one of its lines finds all those in its bucket whose margin is no less. Buckets
/// below the number of cells are cells; from there on they are parts of cells.
class Buckets {
 public:
  /// `parameter_error`: of the parameters of crossings.
  Buckets(std::span<const Approx> lines, double parameter_error, Job& job);

  std::size_t size() const { return cell_node_.size() + parts_.size(); }
  /// A box around a bucket.
  Box box(std::size_t bucket) const {
    return bucket < cell_node_.size() ? cell_box(bucket) : part_boxes_[bucket - cell_node_.size()];
  }
  /// Ascending. Empty for a cell that is split.
  std::span<const LineId> lines(std::size_t bucket) const {
    if (bucket >= cell_node_.size()) return parts_[bucket - cell_node_.size()];
    return cell_node_[bucket] == kNone ? members_[bucket] : std::span<const LineId>();
  }
  std::size_t bucket_at(double x, double y) const {
    const std::size_t cell = row(y) * columns_ + column(x);
    return cell_node_[cell] == kNone ? cell : part_at(cell_node_[cell], x, y);
  }
  const Margin& margin() const { return margin_; }
  /// Whether the bucket's box is all of it, and not just around it.
  bool is_box(std::size_t bucket) const {
    return bucket < cell_node_.size() || part_is_box_[bucket - cell_node_.size()] != 0;
  }

  /// Calls visit(bucket, bottom) for the buckets that the vertical line through (x, y) meets, from
  /// y downwards, until it returns false; on the line, nothing of the bucket is above its
  /// predecessors or, by more than the margin of borders, below `bottom`.
  template <class Visit>
  void down(double x, double y, Visit visit) const {
    const std::size_t c = column(x);
    for (std::size_t r = row(y) + 1; r-- > 0;) {
      const std::size_t cell = r * columns_ + c;
      const double bottom = cell_box(cell).y0;
      if (cell_node_[cell] == kNone ? !visit(cell, bottom)
                                    : !down(cell_node_[cell], x, y, bottom, visit)) {
        return;
      }
    }
  }

  /// Calls visit(bucket) for the buckets that a line comes near.
  template <class Visit>
  void for_near(const Approx& line, Visit visit) const;

 private:
  /// A cell or part of one: a bucket, or a pair of nodes on both sides of a straight line.
  struct Node {
    double x = 0, y = 0;    ///< the line's normal; (0, 0) for a bucket
    double at = 0;          ///< of the line: x times its x + y times its y
    std::uint32_t low = 0;  ///< the bucket, or the node below `at`; the node above is low + 1

    bool is_bucket() const { return x == 0 && y == 0; }
    bool is_high(double px, double py) const { return !(x * px + y * py < at); }
  };
  /// A node still to be split or made a bucket.
  struct Open {
    std::uint32_t node;
    Box box;
    bool is_box;
    std::vector<Piece> members;
  };

  std::size_t part_at(std::uint32_t node, double x, double y) const;
  template <class Visit>
  bool down(std::uint32_t node, double x, double y, double bottom, Visit& visit) const {
    const Node& n = nodes_[node];
    if (n.is_bucket()) return visit(n.low, bottom);
    const bool high = n.is_high(x, y);
    if (n.y == 0) return down(n.low + (high ? 1 : 0), x, y, bottom, visit);
    if (high == (n.y > 0)) {
      const double rounding = 8 * 0x1p-53 * (std::abs(n.at) + std::abs(n.x * x));
      const double border =
          (n.at - n.x * x) / n.y + 4 * (margin_.border + rounding) / std::abs(n.y);
      if (!down(n.low + (high ? 1 : 0), x, y, std::max(bottom, border), visit)) return false;
      if (border < bottom) return true;
    }
    return down(n.low + (n.y > 0 ? 0 : 1), x, y, bottom, visit);
  }

  std::size_t column(double x) const { return index((x - extent_.x0) * per_width_, columns_); }
  std::size_t row(double y) const { return index((y - extent_.y0) * per_height_, rows_); }
  static std::size_t index(double v, std::size_t count) {
    if (!(v > 0)) return 0;
    return v < static_cast<double>(count) ? static_cast<std::size_t>(v) : count - 1;
  }
  /// Without end at the borders of the grid.
  Box cell_box(std::size_t cell) const;
  void choose_grid(std::span<const Approx> lines);
  template <class Visit>
  void for_cells(const Approx& line, Visit visit) const;
  template <class Visit>
  void along(std::uint32_t node, const Approx& line, double slack, Visit& visit) const;
  void fill(std::span<const Approx> lines, Job& job);
  void split_full_cells(std::span<const Approx> lines, Job& job);
  void settle(Open& open, Split& split, std::vector<Open>& next);

  Margin margin_;
  Box extent_{0, 0, 1, 1};  ///< of the grid, whose outer cells go on without end
  std::size_t columns_ = 1, rows_ = 1;
  double column_width_ = 1, row_height_ = 1, per_width_ = 1, per_height_ = 1;
  Grouped<LineId> members_;               ///< per cell
  std::vector<std::uint32_t> cell_node_;  ///< per cell its node, if it is split
  std::vector<Node> nodes_;
  Grouped<LineId> parts_;
  std::vector<Box> part_boxes_;
  std::vector<std::uint8_t> part_is_box_;
};

template <class Visit>
void Buckets::for_cells(const Approx& line, Visit visit) const {
  const auto [bottom, top] = std::minmax(line.ay, line.by);
  const double margin = margin_(line);
  const std::size_t first = row(bottom - margin), last = row(top + margin);
  const Band band(line, margin);
  for (std::size_t r = first; r <= last; ++r) {
    // The outer rows go on.
    const double row_bottom = extent_.y0 + static_cast<double>(r) * row_height_;
    const double low = r == 0 ? -INFINITY : row_bottom;
    const double high = r + 1 == rows_ ? INFINITY : row_bottom + row_height_;
    const auto [x0, x1] =
        first == last ? std::pair(line.ax - margin, line.bx + margin) : band.between(low, high);
    const std::size_t end = column(x1);
    for (std::size_t c = column(x0); c <= end; ++c) visit(r * columns_ + c);
  }
}

template <class Visit>
void Buckets::along(std::uint32_t node, const Approx& line, double slack, Visit& visit) const {
  const Node& n = nodes_[node];
  if (n.is_bucket()) {
    visit(n.low);
    return;
  }
  const auto [low, high] =
      std::minmax({n.x * line.ax + n.y * line.ay, n.x * line.bx + n.y * line.by});
  if (low - slack <= n.at) along(n.low, line, slack, visit);
  if (high + slack >= n.at) along(n.low + 1, line, slack, visit);
}

template <class Visit>
void Buckets::for_near(const Approx& line, Visit visit) const {
  const double slack = 2 * margin_(line);
  for_cells(line, [&](std::size_t cell) {
    if (cell_node_[cell] == kNone) {
      visit(cell);
    } else {
      along(cell_node_[cell], line, slack, visit);
    }
  });
}

}  // namespace plumbline::bucket

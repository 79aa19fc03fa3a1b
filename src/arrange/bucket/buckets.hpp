#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arrange/bucket/types.hpp"

namespace plumbline::bucket {

struct Box {
  double x0, y0, x1, y1;
};

/// The plane divided into boxes ("buckets"), each with the lines that cross it: a uniform grid
/// whose full cells are split further, alternately at the centroid (the idea of LAR's buckets:
/// inters, 2.1). Every point belongs to one bucket. A bucket lists each line that comes within
/// `margin` of it, so a point that is known only to within the margin still finds all its lines in
/// its bucket.
class Buckets {
 public:
  Buckets(std::span<const Approx> lines, double margin);

  std::size_t size() const { return boxes_.size(); }
  const Box& box(std::size_t bucket) const { return boxes_[bucket]; }
  std::span<const LineId> lines(std::size_t bucket) const {
    return {lines_.data() + begin_[bucket], begin_[bucket + 1] - begin_[bucket]};
  }
  std::size_t bucket_at(double x, double y) const;
  double margin() const { return margin_; }

  /// Calls visit(bucket) for the buckets that the vertical line through (x, y) meets, from y
  /// downwards, until it returns false.
  template <class Visit>
  void down(double x, double y, Visit visit) const {
    const std::size_t c = column(x);
    for (std::size_t r = row(y) + 1; r-- > 0;) {
      if (!down(cells_[r * columns_ + c], x, y, visit)) return;
    }
  }

 private:
  /// A cell or part of one: a bucket, or (if `split`) a pair of nodes below and above `at`.
  struct Node {
    double at;
    std::uint32_t low;  ///< the bucket, or the node below; the node above is low + 1
    enum Kind : std::uint32_t { Leaf, SplitX, SplitY } kind;
  };
  template <class Visit>
  bool down(std::uint32_t node, double x, double y, Visit& visit) const {
    const Node& n = nodes_[node];
    if (n.kind == Node::Leaf) return visit(n.low);
    if (n.kind == Node::SplitX) return down(n.low + (x < n.at ? 0 : 1), x, y, visit);
    return (y < n.at || down(n.low + 1, x, y, visit)) && down(n.low, x, y, visit);
  }

  std::size_t column(double x) const;
  std::size_t row(double y) const;
  void choose_grid(std::span<const Approx> lines);
  template <class Visit>
  void for_cells(const Approx& line, Visit visit) const;
  void add_bucket(const Box& box, std::span<const LineId> lines);
  void refine(std::uint32_t node, const Box& box, std::vector<LineId> members,
              std::span<const Approx> lines, int depth);

  double margin_;
  Box extent_{0, 0, 1, 1};
  std::size_t columns_ = 1, rows_ = 1;
  double column_width_ = 1, row_height_ = 1;
  std::vector<std::uint32_t> cells_;  ///< per cell its node
  std::vector<Node> nodes_;
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> begin_{0};
  std::vector<LineId> lines_;
};

}  // namespace plumbline::bucket

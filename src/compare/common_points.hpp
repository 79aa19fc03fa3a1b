#pragma once

#include <optional>
#include <vector>

#include "compare/sides.hpp"

namespace plumbline::compare_steps {

/// The vertices of both sides as one list, in which equal points have one number: predicates need
/// no numbers to see that an edge of one side begins where one of the other side does. Requires:
/// vertices without duplicates. Cost: O(n).
class CommonPoints {
 public:
  explicit CommonPoints(const Sides& sides);
  CommonPoints(const CommonPoints&) = delete;
  CommonPoints& operator=(const CommonPoints&) = delete;

  /// The number of a vertex.
  std::size_t operator()(Side side, VertexId v) const {
    return side == Exact ? v : number_of_float_[v];
  }
  std::size_t size() const { return stored_.size(); }
  /// Made when first asked for: not for several threads.
  const Point& point(std::size_t p) const;
  const PointD& rough(std::size_t p) const { return filtered_.rough(p); }
  double error() const { return filtered_.error(); }
  /// -1, 0, +1: r lies right of, on, left of the line from p to q.
  int orientation(std::size_t p, std::size_t q, std::size_t r) const;
  /// Lexicographic by (x, y).
  bool is_before(std::size_t p, std::size_t q) const { return p != q && filtered_.is_before(p, q); }

 private:
  /// Coordinates with more digits than a double has, where the machine has some: a float vertex
  /// and the exact one that it was rounded from are apart by less than doubles can tell.
  struct Fine {
    long double x, y;
  };
  static std::vector<Fine> fine_points(const PointList& points);

  std::vector<std::size_t> number_of_float_;
  const PointList stored_;  ///< those of the exact side, then the others of the float side
  mutable std::vector<std::optional<Point>> made_;
  const FilteredPoints filtered_;
  const std::vector<Fine> fine_;
  long double fine_error_ = 0;  ///< of a coordinate of `fine_`
};

}  // namespace plumbline::compare_steps

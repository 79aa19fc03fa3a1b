#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "plumbline/detail/iterator.hpp"
#include "plumbline/geometry.hpp"

namespace plumbline {

/// The point (x / w, y / w) in machine integers, not necessarily in lowest terms. Absolute values
/// are below 2^kBits, w > 0.
struct WidePoint {
  __extension__ using Integer = __int128;
  static constexpr int kBits = 126;

  Integer x = 0, y = 0, w = 1;
};

/// The point (x / w, y / w) in integers of any size, not necessarily in lowest terms; w > 0.
struct LongPoint {
  mpz_class x, y, w;
};

/// A sequence of points that stores 48 bytes each: a WidePoint, or where that does not hold the
/// point, which one of a list of LongPoints it is. `operator[]` and iterators make the Point: keep
/// it where it is needed more than once. What else there is reads a point as it is stored.
class PointList {
 public:
  using value_type = Point;
  using const_iterator = ValueIterator<PointList>;

  PointList() = default;
  PointList(std::initializer_list<Point> points)
      : PointList(std::span(points.begin(), points.size())) {}
  explicit PointList(std::span<const Point> points);
  explicit PointList(std::vector<WidePoint> points) : wide_(std::move(points)) {}
  explicit PointList(std::vector<LongPoint> points);

  std::size_t size() const { return wide_.size(); }
  bool empty() const { return wide_.empty(); }
  /// Requires: i < size(); `at` throws std::out_of_range. Const, so that nobody assigns to a copy
  /// by mistake: see `replace`. Cost: two greatest common divisors.
  const Point operator[](std::size_t i) const;
  Point at(std::size_t i) const;
  Point front() const { return (*this)[0]; }
  Point back() const { return (*this)[size() - 1]; }
  const_iterator begin() const { return {*this, 0}; }
  const_iterator end() const { return {*this, static_cast<std::ptrdiff_t>(size())}; }

  /// Coordinates of point i, correctly **rounded** to the nearest doubles. Requires: i < size().
  PointD nearest(std::size_t i) const;
  /// The same, **rounded** towards 0.
  PointD truncated(std::size_t i) const;
  /// Lexicographic order of points i and j, -1, 0 or 1. **Exact**. Requires: both < size().
  int compare(std::size_t i, std::size_t j) const { return compare(*this, i, *this, j); }
  /// The same of point i of one list and point j of another one.
  static int compare(const PointList& a, std::size_t i, const PointList& b, std::size_t j);
  /// Order of points i and j by y alone, -1, 0 or 1. **Exact**. Requires: both < size().
  int compare_y(std::size_t i, std::size_t j) const;
  /// Of points in ascending order, the number of those before p. Cost: O(log n).
  std::size_t count_before(const Point& p) const;
  /// Point i in machine integers; null where they do not hold it. Requires: i < size().
  const WidePoint* wide(std::size_t i) const { return is_wide(i) ? &wide_[i] : nullptr; }
  /// Point i in integers of any size. Requires: i < size(), wide(i) is null.
  const LongPoint& long_point(std::size_t i) const {
    return long_[static_cast<std::size_t>(wide_[i].x)];
  }

  void reserve(std::size_t count) { wide_.reserve(count); }
  void push_back(const Point& point);
  /// Appends point i of another list.
  void push_back(const PointList& other, std::size_t i);
  /// Makes point i another one. Requires: i < size().
  void replace(std::size_t i, const Point& point);
  /// Brings them into another order: point i becomes the one that was point order[i].
  template <class Order>
  void reorder(const Order& order) {
    std::vector<WidePoint> wide;
    wide.reserve(order.size());
    for (const std::size_t i : order) wide.push_back(wide_[i]);
    wide_ = std::move(wide);
  }

  friend bool operator==(const PointList& a, const PointList& b);

 private:
  bool is_wide(std::size_t i) const { return wide_[i].w != 0; }
  void push_back(LongPoint point);

  std::vector<WidePoint> wide_;  ///< with w = 0 the point long_[x]
  std::vector<LongPoint> long_;
};

}  // namespace plumbline

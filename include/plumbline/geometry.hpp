#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plumbline/detail/index.hpp"
#include "plumbline/detail/iterator.hpp"
#include "plumbline/detail/ring.hpp"
#include "plumbline/detail/source.hpp"
#include "plumbline/number.hpp"

namespace plumbline {

using SegmentId = Index<struct SegmentTag>;
using SourceId = Index<struct SourceTag>;

/// A point of the plane with exact coordinates.
struct Point {
  Rational x;
  Rational y;

  friend bool operator==(const Point&, const Point&) = default;
  /// Lexicographic by (x, y).
  friend bool operator<(const Point& p, const Point& q) {
    const int by_x = cmp(p.x, q.x);
    return by_x != 0 ? by_x < 0 : p.y < q.y;
  }
};

/// A point of the plane with double coordinates.
struct PointD {
  double x = 0;
  double y = 0;

  friend bool operator==(const PointD&, const PointD&) = default;
  /// Lexicographic by (x, y).
  friend bool operator<(const PointD& p, const PointD& q) {
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  }
};

/// A straight segment from a to b. In a SegmentSet a != b.
struct Segment {
  Point a;
  Point b;

  friend bool operator==(const Segment&, const Segment&) = default;
};

/// A straight segment with double ends.
struct SegmentD {
  PointD a;
  PointD b;

  friend bool operator==(const SegmentD&, const SegmentD&) = default;
};

/// A point as it is stored: decimals take no memory of their own.
struct NumberPoint {
  Number x;
  Number y;

  friend bool operator==(const NumberPoint&, const NumberPoint&) = default;
};

/// A sequence of segments that stores four Numbers each, 64 bytes if they are decimals. `numbers`
/// reads them as they are stored; `operator[]` and iterators make the Segment.
class SegmentList {
 public:
  using value_type = Segment;
  using const_iterator = ValueIterator<SegmentList>;

  SegmentList() = default;
  SegmentList(std::initializer_list<Segment> segments)
      : SegmentList(std::span(segments.begin(), segments.size())) {}
  explicit SegmentList(std::span<const Segment> segments);

  std::size_t size() const { return numbers_.size() / 4; }
  bool empty() const { return numbers_.empty(); }
  /// Requires: i < size(); `at` throws std::out_of_range.
  Segment operator[](std::size_t i) const;
  Segment at(std::size_t i) const;
  /// ax, ay, bx, by. Requires: i < size().
  std::span<const Number, 4> numbers(std::size_t i) const {
    return std::span<const Number, 4>(numbers_.data() + 4 * i, 4);
  }
  const_iterator begin() const { return {*this, 0}; }
  const_iterator end() const { return {*this, static_cast<std::ptrdiff_t>(size())}; }

  void reserve(std::size_t count) { numbers_.reserve(4 * count); }
  void push_back(Segment segment);
  void push_back(NumberPoint a, NumberPoint b);
  /// Keeps the first `count`. Requires: count <= size().
  void truncate(std::size_t count) {
    numbers_.erase(numbers_.begin() + static_cast<std::ptrdiff_t>(4 * count), numbers_.end());
  }

  friend bool operator==(const SegmentList&, const SegmentList&) = default;

 private:
  std::vector<Number> numbers_;
};

/// Coordinates rounded correctly to the nearest doubles.
PointD nearest(const Point& p);
PointD nearest(const NumberPoint& p);
/// The exact point that two finite doubles are. Throws: Error BadInput.
Point exact(const PointD& p);
/// "x y" in exact text; "ax ay, bx by" for a segment.
std::string to_text(const Point& p);
std::string to_text(const NumberPoint& p);
std::string to_text(const Segment& s);

/// -1, 0, +1: r lies right of, on, left of the line from p to q. **Exact**.
int orientation(const Point& p, const Point& q, const Point& r);
/// Whether r lies on the closed segment pq. **Exact**. Degenerate: p == q is a point.
bool on_segment(const Point& p, const Point& q, const Point& r);
/// Exact squared distance of two points.
Rational squared_distance(const Point& p, const Point& q);
/// Exact squared distance of p from the closed segment ab.
Rational squared_distance(const Point& p, const Point& a, const Point& b);

/// Coordinates of a SegmentSet have absolute values below 2^332, about 8.7e99: so that products of
/// three of them stay within doubles, which CGAL's interval arithmetic needs (it answers wrongly or
/// crashes where intervals overflow).
inline constexpr int kMaxCoordinateBits = 332;
bool is_within_limit(const Point& p);
bool is_within_limit(const Number& coordinate);

/// A text of a drawing: at a place, or without one the name of an element, which names what the
/// closed shapes of its source enclose.
struct Label {
  SourceId source;
  std::string text;
  std::optional<Point> place;
  double height = 0;  ///< of its letters, **rounded**; 0: not known

  friend bool operator==(const Label&, const Label&) = default;
};

/// Exact segments (and isolated points), each with its source; what was refused, and what is to be
/// said of the rest; and the exactness ledger, empty when every coordinate is exactly what the file
/// says.
class SegmentSet {
 public:
  std::vector<std::string> files;
  SourceList sources;
  SegmentList segments;
  std::vector<SourceId> segment_source;  ///< per segment
  /// Per segment how far its points may lie from where they were meant to be, as numbers of twelve
  /// digits and more are what programs print (`evaluate`); empty: nowhere.
  std::vector<double> rounding;
  /// Of polygons and of closed lines without curves, ascending, as far as readers know them.
  std::vector<Ring> rings;
  std::vector<Point> points;           ///< isolated points, for API users; no reader makes them
  std::vector<SourceId> point_source;  ///< per point
  std::vector<Label> labels;
  std::vector<Layer> layers;  ///< that the files declare, in their order
  std::vector<Rejected> rejected;
  std::vector<Remark> remarks;
  std::vector<Replacement> ledger;
  std::string crs;  ///< name of the coordinates' reference system, where the files have one
  std::optional<LengthUnit> unit;  ///< where the files say it
  /// What the last decimal of most numbers of the files is worth, **rounded**; 0: not known.
  double authored_unit = 0;
  bool y_up = false;  ///< whether y runs upwards, in pictures; it does not in SVG

  /// Adds a file name, returns its index.
  std::uint32_t add_file(std::string name);
  SourceId add_source(const Source& source);
  /// Adds a segment; one without length (harmless) or beyond the limit goes to `rejected` instead.
  void add(Segment segment, SourceId source);
  void add(NumberPoint a, NumberPoint b, SourceId source);
  /// Adds the segment with these double coordinates, taken as the dyadic rationals that they are; a
  /// one that is not finite goes to `rejected` as well.
  void add(PointD a, PointD b, SourceId source);
  /// Adds an isolated point; one beyond the limit goes to `rejected` instead.
  void add_point(Point point, SourceId source);
};

}  // namespace plumbline

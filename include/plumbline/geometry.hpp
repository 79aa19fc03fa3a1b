#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "plumbline/number.hpp"

namespace plumbline {

/// An index that can't be mistaken for an index into another array. Converts to std::size_t, so it
/// subscripts; made from a number only explicitly.
template <class Tag>
class Index {
 public:
  constexpr Index() = default;
  constexpr explicit Index(std::size_t value) : value_(static_cast<std::uint32_t>(value)) {}
  constexpr operator std::size_t() const { return value_; }
  constexpr bool valid() const { return value_ != kInvalid; }
  friend constexpr auto operator<=>(Index, Index) = default;
  friend constexpr bool operator==(Index, Index) = default;

 private:
  static constexpr std::uint32_t kInvalid = 0xffffffffU;
  std::uint32_t value_ = kInvalid;
};

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

/// Coordinates rounded correctly to the nearest doubles.
PointD nearest(const Point& p);
/// The exact point that two finite doubles are. Throws: Error BadInput.
Point exact(const PointD& p);
/// "x y" in exact text; "ax ay, bx by" for a segment.
std::string to_text(const Point& p);
std::string to_text(const Segment& s);

/// -1, 0, +1: r lies right of, on, left of the line from p to q. **Exact**.
int orientation(const Point& p, const Point& q, const Point& r);
/// Whether r lies on the closed segment pq. **Exact**. Degenerate: p == q is a point.
bool on_segment(const Point& p, const Point& q, const Point& r);
/// Exact squared distance of two points.
Rational squared_distance(const Point& p, const Point& q);
/// Exact squared distance of p from the closed segment ab.
Rational squared_distance(const Point& p, const Point& a, const Point& b);

/// The element of a drawing that an item came from.
struct Source {
  std::uint32_t file = 0;  ///< index into SegmentSet::files
  std::uint32_t line = 0;  ///< of the element's first character, from 1; 0 means unknown
  std::uint32_t column = 0;
  std::string element;  ///< its name in the format: "line", "rect", "path", "row", ...
  std::string id;       ///< its id in the file, if it has one
  std::string path;     ///< names of the groups or layers above it, outermost first, joined by '/'

  friend bool operator==(const Source&, const Source&) = default;
};

/// An item of the input that takes no part in the result, and why.
struct Rejected {
  Source source;
  std::string reason;
  std::string text;  ///< the offending text, shortened to 60 characters

  friend bool operator==(const Rejected&, const Rejected&) = default;
};

/// One replacement of a number on the way from the file to exact coordinates.
struct Replacement {
  Source source;
  std::string what;   ///< what was replaced, e.g. "rotate(30)"
  std::string bound;  ///< by how much at most, with its unit, e.g. "1e-15 rad"

  friend bool operator==(const Replacement&, const Replacement&) = default;
};

/// Coordinates of a SegmentSet have absolute values below 2^332, about 8.7e99: so that products of
/// three of them stay within doubles, which CGAL's interval arithmetic needs (it answers wrongly or
/// crashes where intervals overflow).
inline constexpr int kMaxCoordinateBits = 332;
bool is_within_limit(const Point& p);

/// Exact segments (and isolated points), each with its source; what was refused; and the exactness
/// ledger, empty when every coordinate is exactly what the file says.
class SegmentSet {
 public:
  std::vector<std::string> files;
  std::vector<Source> sources;
  std::vector<Segment> segments;
  std::vector<SourceId> segment_source;  ///< per segment
  std::vector<Point> points;             ///< isolated points, for API users; no reader makes them
  std::vector<SourceId> point_source;    ///< per point
  std::vector<Rejected> rejected;
  std::vector<Replacement> ledger;

  /// Adds a file name, returns its index.
  std::uint32_t add_file(std::string name);
  SourceId add_source(Source source);
  /// Adds a segment; one without length or beyond the limit goes to `rejected` instead.
  void add(Segment segment, SourceId source);
  /// Adds the segment with these double coordinates, taken as the dyadic rationals that they are; a
  /// one that is not finite goes to `rejected` as well.
  void add(PointD a, PointD b, SourceId source);
  /// Adds an isolated point; one beyond the limit goes to `rejected` instead.
  void add_point(Point point, SourceId source);
};

/// "file:line:column element #id (path)", leaving out what is unknown.
std::string to_text(const Source& source, const std::vector<std::string>& files);

}  // namespace plumbline

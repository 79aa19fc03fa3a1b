#pragma once

#include <random>
#include <string>

#include "plumbline/geometry.hpp"

namespace plumbline::inputs {

inline Point operator+(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y}; }
inline Point operator-(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
inline Point operator*(const Rational& factor, const Point& p) {
  return {factor * p.x, factor * p.y};
}

/// How large inputs are: `Small` ones have some five segments, at most twelve or so.
enum class Extent { Usual, Small };

/// The input being drawn and the dice.
class Draw {
 public:
  Draw(const std::string& family, unsigned seed, Extent extent = Extent::Usual);

  int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  int between(int low, int high) { return low + pick(high - low + 1); }
  bool one_in(int count) { return pick(count) == 0; }
  /// How many things of `each` segments: mostly up to `usual`, seldom up to `most`; in small inputs
  /// as many as have 4, seldom 12 segments.
  int size(int usual, int most, int each = 1);
  /// An integer point of a square of `side`.
  Point lattice(int side) { return {pick(side), pick(side)}; }
  /// Integer coordinates of at most `reach`, not both 0.
  Point vector(int reach);
  /// Strictly between 0 and 1, seldom a decimal.
  Rational fraction();
  /// A small length, from one millionth down to some 1e-30, seldom a decimal.
  Rational tiny();
  /// 10^exponent.
  static Rational power_of_ten(int exponent);

  void add(const Point& a, const Point& b) { set_.add({a, b}, source_); }
  void add_ring(const std::vector<Point>& corners);
  bool empty() const { return set_.segments.empty(); }
  /// One of the segments so far. Requires: !empty().
  Segment any() { return set_.segments[random_() % set_.segments.size()]; }
  /// A point of one of them, strictly inside. Requires: !empty().
  Point any_point();

  /// Some isolated points in each third input: at ends, on segments, elsewhere.
  void add_points(int side);
  /// Replaces all points by their images.
  template <class Map>
  void change(Map map) {
    SegmentList changed;
    for (const Segment& s : set_.segments) changed.push_back({map(s.a), map(s.b)});
    set_.segments = std::move(changed);
    for (Point& p : set_.points) p = map(p);
  }
  /// Rotates the plane by an angle that has rational sine and cosine, and so keeps lengths.
  void rotate();
  /// p, turned about the origin by such an angle: the one whose half has tangent t.
  static Point rotated(const Point& p, const Rational& t);
  /// Leaves integer coordinates as they are, or makes them wide (31 to 60 bits) with ends one unit
  /// off here and there, or other rationals: to reach every kind of number.
  void renumber();

  SegmentSet take();

 private:
  std::mt19937 random_;
  Extent extent_;
  SegmentSet set_;
  SourceId source_;
};

}  // namespace plumbline::inputs

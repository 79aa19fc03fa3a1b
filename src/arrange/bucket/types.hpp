#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::bucket {

/// A line: a segment that shares no more than a point with any other, oriented from its
/// lexicographically first end a to b. One without length (a == b) is a point.
using LineId = std::uint32_t;

/// An end of a line: 2 line (a) or 2 line + 1 (b).
using EndId = std::uint32_t;
constexpr LineId line_of(EndId end) { return end >> 1U; }
constexpr EndId first_end(LineId line) { return 2 * line; }
constexpr EndId last_end(LineId line) { return 2 * line + 1; }
/// Whether an end is the b of its line.
constexpr bool is_last(EndId end) { return (end & 1U) != 0; }

/// Where lines meet. Below twice the number of lines an end, from there on a crossing.
using MeetingId = std::uint32_t;

inline constexpr std::uint32_t kNone = 0xffffffffU;

/// Coordinates of a line rounded to nearest doubles.
struct Approx {
  double ax, ay, bx, by;
};

/// How close to where they are computed to be the points of a line are, and the borders of buckets.
/// With u = 2^-53, r the greatest absolute value of a coordinate of the line and d its length (the
/// greater of width and height): a point a + t (b - a) is off by d times the error of t, and by 8 u
/// r for rounded ends and operations; its rounded projection onto a normal by 6 u r more. Borders
/// of buckets, computed in two ways, are off by 9 u times the greatest coordinate of the grid. What
/// is below kLeast is not told apart: the errors of doubles near 0 are absolute ones.
struct Margin {
  static constexpr double kLeast = 0x1p-960;

  double parameter_error = 0;  ///< of the parameter of a crossing
  double border = 0;           ///< of the borders of buckets

  double operator()(const Approx& l) const {
    const double length = std::max(l.bx - l.ax, std::abs(l.by - l.ay));
    const double reach = std::max({std::abs(l.ax), std::abs(l.ay), std::abs(l.bx), std::abs(l.by)});
    return border + 2 * parameter_error * length + 32 * 0x1p-53 * reach;
  }
};

/// How two lines s and o lie: the exact signs of the orientations of the ends of o to s (`a`, `b`),
/// and of those of s to o. If each crosses the interior of the other, the parameters of the
/// crossing along both (0 at a, 1 at b).
struct Relation {
  int a_to_s, b_to_s, a_to_o, b_to_o;
  double at_s = 0, at_o = 0;

  bool cross() const { return a_to_s * b_to_s < 0 && a_to_o * b_to_o < 0; }
  /// Whether one of them lies strictly on one side of the other.
  bool apart() const { return a_to_s * b_to_s > 0 || a_to_o * b_to_o > 0; }
};

/// Two lines that cross in the interior of both; o turns counter-clockwise from s.
struct Crossing {
  LineId s, o;
};

/// A list of lists as one array.
template <class T>
struct Grouped {
  std::vector<std::uint32_t> begin{0};
  std::vector<T> items;

  std::size_t size() const { return begin.size() - 1; }
  std::span<const T> operator[](std::size_t i) const {
    return {items.data() + begin[i], begin[i + 1] - begin[i]};
  }
};

}  // namespace plumbline::bucket

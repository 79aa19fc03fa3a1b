#pragma once

#include <cstdint>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::bucket {

/// A distinct input segment: oriented from its lexicographically first end a to b, numbered along a
/// space-filling curve. Several input segments may be the same line.
using LineId = std::uint32_t;

/// An end of a line: 2 line (a) or 2 line + 1 (b).
using EndId = std::uint32_t;
constexpr LineId line_of(EndId end) { return end >> 1U; }
constexpr EndId first_end(LineId line) { return 2 * line; }
constexpr EndId last_end(LineId line) { return 2 * line + 1; }
/// Whether an end is the b of its line.
constexpr bool is_last(EndId end) { return (end & 1U) != 0; }

/// Where lines meet. Below `Meetings::ends` a distinct end point, from there on a crossing.
using MeetingId = std::uint32_t;

/// Coordinates of a line rounded to nearest doubles.
struct Approx {
  double ax, ay, bx, by;
};

/// An orientation: its exact sign, and its magnitude with a relative error of at most
/// Kernel::kRelativeError.
struct Value {
  int sign;
  double magnitude;
};

/// Two lines that cross in the interior of both, at these parameters (0 at a, 1 at b).
struct Crossing {
  LineId s, o;
  double at_s, at_o;
};

/// A meeting on a line, strictly between its ends.
struct Hit {
  double at;
  MeetingId meeting;
};

}  // namespace plumbline::bucket

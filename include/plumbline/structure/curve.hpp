#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// The image of the unit circle: centre + x u + y v.
struct Ellipse {
  Point centre;
  Point u, v;

  friend bool operator==(const Ellipse&, const Ellipse&) = default;
};

/// A curve of a Model, which segments replace: its chords, one after the other.
struct Curve {
  std::uint32_t first = 0, count = 0;  ///< its chords among the segments of the Model
  std::optional<Ellipse> ellipse;      ///< what it is a part of; none for a Bezier curve
  double chord_bound = 0;  ///< between the curve and its chords nothing is further apart
  /// How far its first and its last end may lie from where the file has them: by the rounding of
  /// the file's own long numbers, and by what stands for sines and cosines. 0: exactly there.
  std::array<double, 2> end_bounds = {};
  double bound = 0;  ///< the same of its other points

  friend bool operator==(const Curve&, const Curve&) = default;
};

}  // namespace plumbline

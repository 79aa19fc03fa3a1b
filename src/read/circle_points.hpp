#pragma once

#include <cstdint>
#include <vector>

namespace plumbline {

/// Points of the unit circle, (x / denominator, y / denominator): those of the quarter from (1, 0)
/// on, without (0, 1), in turning order. The quarter is its own mirror image at the diagonal.
struct CircleQuarter {
  struct Integers {
    std::int64_t x = 0, y = 0;
  };

  std::int64_t denominator = 1;
  std::vector<Integers> points;
};

/// Rational points of the unit circle over common denominators, as small as possible, so that
/// circles of decimals stay on a common grid. A number p that is a sum of squares a^2 + b^2 has
/// the point (a^2 - b^2, 2 a b) / p; turning by it multiplies the denominator by p. Each
/// denominator divides the next.
class CirclePoints {
 public:
  /// The shortest chord that `quarter` takes.
  static constexpr double kShortestChord = 7e-5;

  CirclePoints();
  /// A quarter whose chords, that from the last point to (0, 1) included, are no longer than
  /// `longest`. Requires: longest >= kShortestChord.
  CircleQuarter quarter(double longest);

 private:
  /// The points of an eighth, from (1, 0) to the diagonal, over one denominator.
  struct Level {
    std::int64_t denominator;
    std::vector<CircleQuarter::Integers> eighth;
    double longest_chord;
  };
  void add_level();

  std::vector<Level> levels_;
};

}  // namespace plumbline

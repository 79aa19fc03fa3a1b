#pragma once

#include <array>
#include <optional>

#include "arrange/bucket/types.hpp"
#include "arrange/bucket/wide.hpp"

namespace plumbline::bucket {

/// Lines whose coordinates are integers of at most kBits bits, on the common grid of the drawing's
/// decimals. Every predicate is decided in fixed-size integers: differences need kBits + 1 bits,
/// orientations 2 kBits + 3 <= 123, so a sum of two of them fits 128 bits; products of two of them
/// 256.
class GridKernel {
 public:
  using Coordinates = std::array<std::int64_t, 4>;  ///< ax, ay, bx, by
  static constexpr int kBits = 60;
  /// Rounding of a 128-bit integer to double.
  static constexpr double kRelativeError = 0x1p-53;

  /// The input's segments, then its points (as lines without length), on their common grid; nothing
  /// if they do not fit.
  static std::optional<GridKernel> from(const SegmentSet& input);

  std::size_t size() const { return lines_.size(); }
  /// The same lines in another order, without those left out.
  void reorder(const std::vector<LineId>& order);
  bool equal(LineId s, LineId o) const { return lines_[s] == lines_[o]; }
  bool less(LineId s, LineId o) const { return lines_[s] < lines_[o]; }

  Approx approx(LineId s) const {
    const Coordinates& c = lines_[s];
    return {double(c[0]), double(c[1]), double(c[2]), double(c[3])};
  }

  /// On which side of line s (positive: left) an end lies; magnitude: the cross product.
  Value orientation(LineId s, EndId end) const {
    const Int128 v = cross(s, end);
    return {bucket::sign(v), static_cast<double>(v < 0 ? -v : v)};
  }
  int side(LineId s, EndId end) const { return bucket::sign(cross(s, end)); }
  /// The parameter along s of its crossing with o, with the error of a quotient of two Values.
  double rounded_parameter(LineId s, LineId o) const {
    const auto [n, d] = parameter(s, o);
    return static_cast<double>(n) / static_cast<double>(d);
  }
  /// Sign of the cross product of the directions of two lines.
  int compare_directions(LineId s, LineId o) const {
    const Coordinates &c = lines_[s], &d = lines_[o];
    return bucket::sign(Int128(c[2] - c[0]) * (d[3] - d[1]) - Int128(c[3] - c[1]) * (d[2] - d[0]));
  }

  /// Lexicographic order of two ends.
  int compare(EndId p, EndId q) const {
    if (x(p) != x(q)) return x(p) < x(q) ? -1 : 1;
    return y(p) < y(q) ? -1 : (y(p) > y(q) ? 1 : 0);
  }
  int compare_x(EndId p, EndId q) const { return x(p) < x(q) ? -1 : (x(p) > x(q) ? 1 : 0); }

  /// Order along s of its crossings with o and q.
  int compare_along(LineId s, LineId o, LineId q) const;
  /// The side of line c on which the crossing of s and o lies.
  int side_of_crossing(LineId c, LineId s, LineId o) const;
  /// Order of the x coordinates of the crossing of s and o, and of an end.
  int compare_x(LineId s, LineId o, EndId end) const;
  /// Order of the heights of s and o just right of an end's x. Requires: both are met there.
  int compare_heights(LineId s, LineId o, EndId end) const;

  Point point(EndId end) const;
  Point crossing(LineId s, LineId o) const;

 private:
  bool add(const Point& a, const Point& b);
  std::int64_t x(EndId end) const { return lines_[line_of(end)][is_last(end) ? 2 : 0]; }
  std::int64_t y(EndId end) const { return lines_[line_of(end)][is_last(end) ? 3 : 1]; }
  Int128 cross(LineId s, EndId end) const {
    const Coordinates& c = lines_[s];
    return Int128(c[2] - c[0]) * (y(end) - c[1]) - Int128(c[3] - c[1]) * (x(end) - c[0]);
  }
  /// The parameter of the crossing with o along s as numerator / positive denominator.
  std::pair<Int128, Int128> parameter(LineId s, LineId o) const;

  std::vector<Coordinates> lines_;
  mpz_class scale_;
};

}  // namespace plumbline::bucket

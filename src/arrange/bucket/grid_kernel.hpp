#pragma once

#include <array>
#include <cmath>
#include <type_traits>

#include "arrange/bucket/grid_input.hpp"
#include "arrange/bucket/job.hpp"
#include "arrange/bucket/types.hpp"
#include "arrange/bucket/wide.hpp"

namespace plumbline::bucket {

/// Lines whose coordinates are integers of at most kBits bits. Every predicate is decided in
/// fixed-size integers: differences need kBits + 1 bits, cross products of them 2 kBits + 3 (with
/// the sign 2 kBits + 4 = 64 or 124), so they and sums of two fit Wide; comparisons of products of
/// two of those fit twice that.
template <class Coordinate>
class GridKernel {
 public:
  static constexpr bool kNarrow = std::is_same_v<Coordinate, std::int32_t>;
  static constexpr int kBits = kNarrow ? 30 : GridInput::kBits;
  using Wide = std::conditional_t<kNarrow, std::int64_t, Int128>;
  using Coordinates = std::array<Coordinate, 4>;  ///< ax, ay, bx, by
  /// Of an orientation rounded to double.
  static constexpr double kRelativeError = 0x1p-53;

  static bool fits(const GridInput& input) { return (input.largest >> kBits) == 0; }
  GridKernel() = default;
  explicit GridKernel(const GridInput& input);

  std::size_t size() const { return lines_.size(); }
  /// Adds the line from one end to another, which lies on it or is the same point.
  LineId join(EndId a, EndId b);
  /// The lines in another order, without those left out.
  void reorder(const std::vector<LineId>& order, Job& job);
  bool is_point(LineId s) const {
    return lines_[s][0] == lines_[s][2] && lines_[s][1] == lines_[s][3];
  }
  /// Keys of the lines from begin to end: equal for lines on one supporting line, for equal points.
  void keys(std::size_t begin, std::size_t end, std::uint64_t* key) const;

  Approx approx(LineId s) const {
    const Coordinates& c = lines_[s];
    return {double(c[0]), double(c[1]), double(c[2]), double(c[3])};
  }

  /// With w = o.a - s.a: orientations of the ends of o to s are ds x w and ds x (w + do), of those
  /// of s to o do x -w and do x (ds - w).
  Relation relate(LineId s, LineId o) const {
    const Coordinates &c = lines_[s], &d = lines_[o];
    const Wide dx = Wide(c[2]) - c[0], dy = Wide(c[3]) - c[1];
    const Wide ex = Wide(d[2]) - d[0], ey = Wide(d[3]) - d[1];
    const Wide wx = Wide(d[0]) - c[0], wy = Wide(d[1]) - c[1];
    const Wide turn = dx * ey - dy * ex;
    const Wide oa = dx * wy - dy * wx, ob = oa + turn;
    const Wide sa = ey * wx - ex * wy, sb = sa - turn;
    Relation r{sign(oa), sign(ob), sign(sa), sign(sb)};
    if (r.cross()) {
      const double whole = std::abs(static_cast<double>(turn));
      r.at_s = std::abs(static_cast<double>(sa)) / whole;
      r.at_o = std::abs(static_cast<double>(oa)) / whole;
    }
    return r;
  }
  /// On which side of line s (positive: left) an end lies.
  int side(LineId s, EndId end) const { return sign(cross(s, end)); }
  /// Sign of the cross product of the directions of two lines.
  int compare_directions(LineId s, LineId o) const {
    const Coordinates &c = lines_[s], &d = lines_[o];
    return sign((Wide(c[2]) - c[0]) * (Wide(d[3]) - d[1]) -
                (Wide(c[3]) - c[1]) * (Wide(d[2]) - d[0]));
  }
  /// The parameter along s of its crossing with o, with an error of three roundings.
  double parameter(LineId s, LineId o) const {
    const auto [n, d] = fraction(s, o);
    return static_cast<double>(n) / static_cast<double>(d);
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
  Coordinate x(EndId end) const { return lines_[line_of(end)][is_last(end) ? 2 : 0]; }
  Coordinate y(EndId end) const { return lines_[line_of(end)][is_last(end) ? 3 : 1]; }
  Wide cross(LineId s, EndId end) const {
    const Coordinates& c = lines_[s];
    return (Wide(c[2]) - c[0]) * (Wide(y(end)) - c[1]) -
           (Wide(c[3]) - c[1]) * (Wide(x(end)) - c[0]);
  }
  /// The parameter of the crossing with o along s as numerator / positive denominator.
  std::pair<Wide, Wide> fraction(LineId s, LineId o) const;

  std::vector<Coordinates> lines_;
  mpz_class scale_;
  mpz_class middle_x_, middle_y_;
};

extern template class GridKernel<std::int32_t>;
extern template class GridKernel<std::int64_t>;

}  // namespace plumbline::bucket

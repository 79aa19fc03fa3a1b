#pragma once

#include <cmath>

#include "arrange/bucket/exact_lines.hpp"
#include "arrange/bucket/grid_input.hpp"
#include "plumbline/geometry/point_list.hpp"

namespace plumbline::bucket {

/// Lines whose coordinates are integers of at most 30 bits: every predicate is decided at once in
/// 64-bit integers, comparisons of products in 128.
class GridKernel : public ExactLines<std::int32_t> {
 public:
  /// Of a parameter: three roundings.
  static constexpr double kParameterError = 0x1p-51;

  static bool fits(const GridInput& input) {
    return (input.largest >> Arithmetic<std::int32_t>::kBits) == 0;
  }
  GridKernel() = default;
  explicit GridKernel(const GridInput& input);

  Approx approx(LineId s) const {
    const Line& c = (*this)[s];
    return {double(c[0]), double(c[1]), double(c[2]), double(c[3])};
  }

  /// Whether an end of s is the same point as one of o.
  bool share_end(LineId s, LineId o) const {
    const Line &c = (*this)[s], &d = (*this)[o];
    const auto same = [](std::int32_t x, std::int32_t y, std::int32_t u, std::int32_t v) {
      return ((x ^ u) | (y ^ v)) == 0;
    };
    return same(c[0], c[1], d[0], d[1]) || same(c[0], c[1], d[2], d[3]) ||
           same(c[2], c[3], d[0], d[1]) || same(c[2], c[3], d[2], d[3]);
  }
  /// With w = o.a - s.a: orientations of the ends of o to s are ds x w and ds x (w + do), of those
  /// of s to o do x -w and do x (ds - w).
  Relation relate(LineId s, LineId o) const {
    const Line &c = (*this)[s], &d = (*this)[o];
    const std::int64_t dx = Difference(c[2]) - c[0], dy = Difference(c[3]) - c[1];
    const std::int64_t ex = Difference(d[2]) - d[0], ey = Difference(d[3]) - d[1];
    const std::int64_t wx = Difference(d[0]) - c[0], wy = Difference(d[1]) - c[1];
    const std::int64_t turn = dx * ey - dy * ex;
    const std::int64_t oa = dx * wy - dy * wx, ob = oa + turn;
    const std::int64_t sa = ey * wx - ex * wy, sb = sa - turn;
    Relation r{sign(oa), sign(ob), sign(sa), sign(sb)};
    if (r.cross()) {
      const double whole = std::abs(static_cast<double>(turn));
      r.at_s = std::abs(static_cast<double>(sa)) / whole;
      r.at_o = std::abs(static_cast<double>(oa)) / whole;
    }
    return r;
  }

  /// Whether a WidePoint holds every point there can be; then the same in machine integers.
  bool has_wide_points() const { return wide_scale_ != 0; }
  WidePoint wide_point(EndId end) const {
    return {wide_x_ + x(end), wide_y_ + y(end), wide_scale_};
  }
  WidePoint wide_crossing(LineId s, LineId o) const {
    const auto [n, d] = fraction(s, o);
    const Line& c = (*this)[s];
    return {(wide_x_ + c[0]) * d + (Int128(c[2]) - c[0]) * n,
            (wide_y_ + c[1]) * d + (Int128(c[3]) - c[1]) * n, d * wide_scale_};
  }

 private:
  Int128 wide_scale_ = 0, wide_x_ = 0, wide_y_ = 0;  ///< the frame, where there are wide points
};

}  // namespace plumbline::bucket

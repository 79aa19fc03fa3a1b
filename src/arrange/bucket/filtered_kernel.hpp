#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "arrange/bucket/exact_lines.hpp"
#include "arrange/bucket/grid_input.hpp"

namespace plumbline::bucket {

/// Lines with any rational coordinates. Doubles with a certified bound of their error come first;
/// what they cannot decide is decided in integers: of 124 bits on a common grid, where there is
/// one, else with a denominator for each line, of 255 bits, or where not all are, of any size. The
/// same interface as GridKernel.
class FilteredKernel {
 public:
  /// Of a parameter that doubles tell.
  static constexpr double kParameterError = 0x1p-36;

  FilteredKernel() = default;
  /// On the grid.
  FilteredKernel(GridInput input, Job& job);
  /// Whatever the coordinates are.
  FilteredKernel(const SegmentSet& input, Job& job);

  std::size_t size() const { return approx_.size(); }
  LineId join(EndId a, EndId b);
  void resize(std::size_t size);
  void reorder(const std::vector<LineId>& order, Job& job);
  bool is_point(LineId s) const {
    const Approx& l = approx_[s];
    return l.ax == l.bx && l.ay == l.by && exact_is_point(s);
  }
  void keys(std::size_t begin, std::size_t end, std::uint64_t* key) const;
  /// Coordinates relative to a point in the middle of most lines, divided by a power of two if they
  /// are very large or small.
  Approx approx(LineId s) const { return approx_[s]; }

  /// Whether an end of s is the same point as one of o.
  bool share_end(LineId s, LineId o) const {
    for (const EndId p : {first_end(s), last_end(s)}) {
      for (const EndId q : {first_end(o), last_end(o)}) {
        if (place(p) == place(q) && exact_compare(p, q) == 0) return true;
      }
    }
    return false;
  }

  Relation relate(LineId s, LineId o) const {
    const Approx &l = approx_[s], &m = approx_[o];
    const double far = std::max(reach(l), reach(m));
    const double dx = l.bx - l.ax, dy = l.by - l.ay;
    const double ax = m.ax - l.ax, ay = m.ay - l.ay, bx = m.bx - l.ax, by = m.by - l.ay;
    const double oa = dx * ay - dy * ax, ob = dx * by - dy * bx;
    const double to_s = error_of(largest({dx, dy, ax, ay, bx, by}), far);
    Relation r{sign_of(oa, to_s, s, first_end(o)), 0, 0, 0};
    r.b_to_s = sign_of(ob, to_s, s, last_end(o));
    if (r.apart()) return r;
    const double ex = m.bx - m.ax, ey = m.by - m.ay, cx = l.bx - m.ax, cy = l.by - m.ay;
    const double sa = ey * ax - ex * ay, sb = ex * cy - ey * cx;
    const double to_o = error_of(largest({ex, ey, ax, ay, cx, cy}), far);
    r.a_to_o = sign_of(sa, to_o, o, first_end(s));
    r.b_to_o = sign_of(sb, to_o, o, last_end(s));
    if (r.cross()) {
      r.at_s = quotient(sa, sb, to_o, s, o);
      r.at_o = quotient(oa, ob, to_s, o, s);
    }
    return r;
  }
  /// The parameter along s of its crossing with o, with an error of kParameterError.
  double parameter(LineId s, LineId o) const;
  int side(LineId s, EndId end) const {
    const Approx& l = approx_[s];
    const PointD p = place(end);
    const double dx = l.bx - l.ax, dy = l.by - l.ay, ex = p.x - l.ax, ey = p.y - l.ay;
    const double size = largest({dx, dy, ex, ey});
    const double far = std::max(reach(l), largest({p.x, p.y}));
    return sign_of(dx * ey - dy * ex, error_of(size, far), s, end);
  }
  int compare_directions(LineId s, LineId o) const;

  // Rounding to nearest keeps the order, so doubles that differ tell it.
  int compare(EndId p, EndId q) const {
    const PointD a = place(p), b = place(q);
    if (a.x != b.x) return a.x < b.x ? -1 : 1;
    return exact_compare(p, q);
  }
  int compare_x(EndId p, EndId q) const {
    const PointD a = place(p), b = place(q);
    if (a.x != b.x) return a.x < b.x ? -1 : 1;
    return exact_compare_x(p, q);
  }

  int compare_along(LineId s, LineId o, LineId q) const;
  int side_of_crossing(LineId c, LineId s, LineId o) const;
  int compare_x(LineId s, LineId o, EndId end) const;
  int compare_heights(LineId s, LineId o, EndId end) const;

  LongPoint point(EndId end) const;
  LongPoint crossing(LineId s, LineId o) const;

 private:
  /// The largest absolute value.
  template <std::size_t N>
  static double largest(const double (&values)[N]) {
    double result = 0;
    for (const double v : values) result = std::max(result, std::abs(v));
    return result;
  }
  static double reach(const Approx& l) { return largest({l.ax, l.ay, l.bx, l.by}); }
  /// A bound on the error of a cross product of differences of rounded coordinates: differences of
  /// absolute value at most `size`, coordinates at most `reach`. With u = 2^-53, a coordinate is
  /// off by u reach, so a difference of two by 2 u reach, and its own rounding adds at most 2 u
  /// reach: e = 4 u reach. Two products of differences that are off by e: 4 e size + 2 e^2. As size
  /// is at most 2 reach, the roundings of the products add 2 u size^2 <= e size, that of their
  /// difference as much. The factor 1.01 covers higher orders and the rounding of the bound itself,
  /// the last term products that underflow.
  static double error_of(double size, double reach) {
    const double e = 4 * 0x1p-53 * reach;
    return 1.01 * e * (6 * size + 2 * e) + 8 * std::numeric_limits<double>::min();
  }
  int sign_of(double value, double error, LineId s, EndId end) const {
    if (value > error) return 1;
    if (value < -error) return -1;
    return exact_side(s, end);
  }
  /// The parameter along s of its crossing with o, from the orientations of the ends of s to o,
  /// which are on both sides: with errors of `error` each it is off by that, divided by their
  /// distance, and some roundings.
  double quotient(double from, double to, double error, LineId s, LineId o) const {
    const double a = std::abs(from), whole = a + std::abs(to);
    return error < whole * (kParameterError / 4) ? a / whole : exact_parameter(s, o);
  }
  PointD place(EndId end) const {
    const Approx& l = approx_[line_of(end)];
    return is_last(end) ? PointD{l.bx, l.by} : PointD{l.ax, l.ay};
  }

  bool exact_is_point(LineId s) const;
  int exact_side(LineId s, EndId end) const;
  int exact_compare(EndId p, EndId q) const;
  int exact_compare_x(EndId p, EndId q) const;
  double exact_parameter(LineId s, LineId o) const;

  std::variant<ExactLines<Int128>, ExactLines<Words>, ExactLines<mpz_class>> exact_;
  std::vector<Approx> approx_;
};

}  // namespace plumbline::bucket

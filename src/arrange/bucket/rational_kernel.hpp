#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "arrange/bucket/job.hpp"
#include "arrange/bucket/types.hpp"

namespace plumbline::bucket {

/// Lines with any rational coordinates. A double filter with a certified bound comes first; what it
/// cannot decide is decided in rationals. The same interface as GridKernel.
class RationalKernel {
 public:
  using Coordinates = std::array<Rational, 4>;  ///< ax, ay, bx, by
  /// The filter accepts an orientation only if its error bound is below this part of it.
  static constexpr double kRelativeError = 0x1p-30;

  RationalKernel(const SegmentSet& input, Job& job);

  std::size_t size() const { return lines_.size(); }
  LineId join(EndId a, EndId b);
  void reorder(const std::vector<LineId>& order, Job& job);
  bool is_point(LineId s) const {
    return lines_[s][0] == lines_[s][2] && lines_[s][1] == lines_[s][3];
  }
  void keys(std::size_t begin, std::size_t end, std::uint64_t* key) const;
  /// Coordinates relative to the first one, divided by a power of two that takes the largest of
  /// them into [1/4, 1).
  Approx approx(LineId s) const { return approx_[s]; }

  Relation relate(LineId s, LineId o) const {
    Relation r{side(s, first_end(o)), side(s, last_end(o)), side(o, first_end(s)),
               side(o, last_end(s))};
    if (r.cross()) {
      r.at_s = parameter(s, o);
      r.at_o = parameter(o, s);
    }
    return r;
  }
  /// The parameter along s of its crossing with o, with an error of a few times kRelativeError.
  double parameter(LineId s, LineId o) const;
  int side(LineId s, EndId end) const {
    const Filtered f = filtered(s, end);
    if (f.error < std::abs(f.value)) return f.value > 0 ? 1 : -1;
    return sgn(cross(s, end));
  }
  int compare_directions(LineId s, LineId o) const;

  int compare(EndId p, EndId q) const {
    const int by_x = compare_x(p, q);
    return by_x != 0 ? by_x : cmp(y(p), y(q));
  }
  int compare_x(EndId p, EndId q) const { return cmp(x(p), x(q)); }

  int compare_along(LineId s, LineId o, LineId q) const;
  int side_of_crossing(LineId c, LineId s, LineId o) const;
  int compare_x(LineId s, LineId o, EndId end) const;
  int compare_heights(LineId s, LineId o, EndId end) const;

  Point point(EndId end) const { return {x(end), y(end)}; }
  Point crossing(LineId s, LineId o) const;

 private:
  /// A cross product in doubles and a bound on its error.
  struct Filtered {
    double value, error;
  };
  const Rational& x(EndId end) const { return lines_[line_of(end)][is_last(end) ? 2 : 0]; }
  const Rational& y(EndId end) const { return lines_[line_of(end)][is_last(end) ? 3 : 1]; }
  Filtered filtered(LineId s, EndId end) const;
  Rational cross(LineId s, EndId end) const;
  Rational height(LineId s, EndId end) const;
  Rational exact_parameter(LineId s, LineId o) const;

  std::vector<Coordinates> lines_;
  std::vector<Approx> approx_;
  long exponent_ = 0;  ///< the power of two
};

}  // namespace plumbline::bucket

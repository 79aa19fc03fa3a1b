#include "arrange/bucket/rational_kernel.hpp"

#include <algorithm>
#include <limits>

namespace plumbline::bucket {
namespace {

constexpr double kRounding = 0x1p-53;

/// value / 2^exponent, exactly.
Rational scaled(const Rational& value, long exponent) {
  Rational result;
  if (exponent >= 0) {
    mpq_div_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_mul_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return result;
}

/// The least e with |value| < 2^e, or one more; 0 for 0.
long exponent_of(const Rational& value) {
  if (sgn(value) == 0) return 0;
  const auto bits = [](mpz_srcptr z) { return static_cast<long>(mpz_sizeinbase(z, 2)); };
  return bits(value.get_num_mpz_t()) - bits(value.get_den_mpz_t()) + 1;
}

/// Two coordinates of absolute value below 1, with an error of kRounding / 2 each, and the rounding
/// of their difference, which is below 2; and what underflow adds.
constexpr double kDifferenceError = 4.01 * kRounding;

}  // namespace

RationalKernel RationalKernel::from(const SegmentSet& input) {
  RationalKernel kernel;
  const auto add = [&](const Point& a, const Point& b) {
    kernel.lines_.push_back({a.x, a.y, b.x, b.y});
  };
  for (const Segment& s : input.segments) {
    if (s.a < s.b) {
      add(s.a, s.b);
    } else {
      add(s.b, s.a);
    }
  }
  for (const Point& p : input.points) add(p, p);

  bool first = true;
  for (const Coordinates& line : kernel.lines_) {
    for (const Rational& c : line) {
      if (sgn(c) == 0) continue;
      kernel.exponent_ = first ? exponent_of(c) : std::max(kernel.exponent_, exponent_of(c));
      first = false;
    }
  }
  for (const Coordinates& line : kernel.lines_) {
    const auto approx = [&](std::size_t i) {
      return nearest_double(scaled(line[i], kernel.exponent_));
    };
    kernel.approx_.push_back({approx(0), approx(1), approx(2), approx(3)});
  }
  return kernel;
}

double RationalKernel::magnitude(const Rational& cross) const {
  return std::abs(nearest_double(scaled(cross, 2 * exponent_)));
}

void RationalKernel::reorder(const std::vector<LineId>& order) {
  std::vector<Coordinates> lines;
  std::vector<Approx> approx;
  for (const LineId s : order) {
    lines.push_back(std::move(lines_[s]));
    approx.push_back(approx_[s]);
  }
  lines_ = std::move(lines);
  approx_ = std::move(approx);
}

// value = dx ey - dy ex with differences known to within e. The exact differences lead to a value
// within e (|dx| + |dy| + |ex| + |ey|) + 2 e^2 of the one computed exactly from the rounded
// differences; two products and a difference add at most 2 kRounding (|dx ey| + |dy ex|) to first
// order. The factor 1.01 covers higher orders and the rounding of the bound itself, the last term
// products that underflow.
RationalKernel::Filtered RationalKernel::filtered(LineId s, EndId end) const {
  const Approx &l = approx_[s], &m = approx_[line_of(end)];
  const bool head = is_last(end);
  const double dx = l.bx - l.ax, dy = l.by - l.ay;
  const double ex = (head ? m.bx : m.ax) - l.ax, ey = (head ? m.by : m.ay) - l.ay;
  const double left = dx * ey, right = dy * ex, e = kDifferenceError;
  const double sum = std::abs(dx) + std::abs(dy) + std::abs(ex) + std::abs(ey) + 2 * e;
  const double error = 1.01 * (e * sum + 2 * kRounding * (std::abs(left) + std::abs(right))) +
                       8 * std::numeric_limits<double>::min();
  return {left - right, error};
}

Rational RationalKernel::cross(LineId s, EndId end) const {
  const Coordinates& c = lines_[s];
  return (c[2] - c[0]) * (y(end) - c[1]) - (c[3] - c[1]) * (x(end) - c[0]);
}

int RationalKernel::compare_directions(LineId s, LineId o) const {
  const Coordinates &c = lines_[s], &d = lines_[o];
  const Rational left = (c[2] - c[0]) * (d[3] - d[1]), right = (c[3] - c[1]) * (d[2] - d[0]);
  return cmp(left, right);
}

Rational RationalKernel::parameter(LineId s, LineId o) const {
  const Rational from = cross(o, first_end(s)), to = cross(o, last_end(s));
  return from / (from - to);
}

int RationalKernel::compare_along(LineId s, LineId o, LineId q) const {
  return cmp(parameter(s, o), parameter(s, q));
}

int RationalKernel::side_of_crossing(LineId c, LineId s, LineId o) const {
  const Point p = crossing(s, o);
  const Coordinates& l = lines_[c];
  const Rational left = (l[2] - l[0]) * (p.y - l[1]), right = (l[3] - l[1]) * (p.x - l[0]);
  return cmp(left, right);
}

int RationalKernel::compare_x(LineId s, LineId o, EndId end) const {
  return cmp(crossing(s, o).x, x(end));
}

Rational RationalKernel::height(LineId s, EndId end) const {
  const Coordinates& c = lines_[s];
  return c[1] + (c[3] - c[1]) * (x(end) - c[0]) / (c[2] - c[0]);
}

int RationalKernel::compare_heights(LineId s, LineId o, EndId end) const {
  const int by_height = cmp(height(s, end), height(o, end));
  return by_height != 0 ? by_height : -compare_directions(s, o);
}

Point RationalKernel::crossing(LineId s, LineId o) const {
  const Coordinates& c = lines_[s];
  const Rational t = parameter(s, o);
  return {c[0] + t * (c[2] - c[0]), c[1] + t * (c[3] - c[1])};
}

}  // namespace plumbline::bucket

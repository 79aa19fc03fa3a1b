#include "arrange/bucket/rational_kernel.hpp"

#include <algorithm>
#include <limits>

#include "arrange/bucket/prime_field.hpp"

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

/// The residue of a rational in lowest terms modulo the prime; kNoResidue if it has none.
std::uint64_t residue(const Rational& value) {
  namespace field = prime_field;
  const std::uint64_t d = mpz_fdiv_ui(value.get_den_mpz_t(), field::kPrime);
  if (d == 0) return field::kNoResidue;
  return field::multiply(mpz_fdiv_ui(value.get_num_mpz_t(), field::kPrime), field::inverse(d));
}

}  // namespace

RationalKernel::RationalKernel(const SegmentSet& input, Job& job)
    : lines_(input.segments.size() + input.points.size()), approx_(lines_.size()) {
  const std::size_t segments = input.segments.size();
  job.for_each(lines_.size(), [&](std::size_t i) {
    const auto [p, q] = i < segments
                            ? input.segments[i]
                            : Segment{input.points[i - segments], input.points[i - segments]};
    const Point &a = q < p ? q : p, &b = q < p ? p : q;
    lines_[i] = {a.x, a.y, b.x, b.y};
  });
  if (lines_.empty()) return;
  const Point origin{lines_[0][0], lines_[0][1]};
  bool first = true;
  for (const Coordinates& line : lines_) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Rational c = line[i] - (i % 2 == 0 ? origin.x : origin.y);
      if (sgn(c) == 0) continue;
      exponent_ = first ? exponent_of(c) : std::max(exponent_, exponent_of(c));
      first = false;
    }
  }
  job.for_each(lines_.size(), [&](std::size_t s) {
    const auto rounded = [&](std::size_t i) {
      return nearest_double(scaled(lines_[s][i] - (i % 2 == 0 ? origin.x : origin.y), exponent_));
    };
    approx_[s] = {rounded(0), rounded(1), rounded(2), rounded(3)};
  });
}

LineId RationalKernel::join(EndId a, EndId b) {
  lines_.push_back({x(a), y(a), x(b), y(b)});
  const auto place = [&](EndId end) {
    const Approx& l = approx_[line_of(end)];
    return is_last(end) ? PointD{l.bx, l.by} : PointD{l.ax, l.ay};
  };
  const PointD p = place(a), q = place(b);
  approx_.push_back({p.x, p.y, q.x, q.y});
  return static_cast<LineId>(lines_.size() - 1);
}

void RationalKernel::reorder(const std::vector<LineId>& order, Job& job) {
  std::vector<Coordinates> lines(order.size());
  std::vector<Approx> approx(order.size());
  job.for_each(order.size(), [&](std::size_t i) {
    lines[i].swap(lines_[order[i]]);
    approx[i] = approx_[order[i]];
  });
  lines_ = std::move(lines);
  approx_ = std::move(approx);
}

void RationalKernel::keys(std::size_t begin, std::size_t end, std::uint64_t* key) const {
  namespace field = prime_field;
  for (std::size_t s = begin; s < end; ++s) {
    const Coordinates& c = lines_[s];
    std::uint64_t& k = key[s - begin];
    if (c[0] != c[2]) {
      const Rational slope = (c[3] - c[1]) / (c[2] - c[0]), height = c[1] - slope * c[0];
      k = field::key(residue(slope), residue(height));
    } else if (c[1] != c[3]) {
      k = field::key(field::kVertical, residue(c[0]));
    } else {
      k = field::key(field::kPoint, field::key(residue(c[0]), residue(c[1])));
    }
  }
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

// The two orientations have a relative error of kRelativeError each.
double RationalKernel::parameter(LineId s, LineId o) const {
  const Filtered a = filtered(o, first_end(s)), b = filtered(o, last_end(s));
  if (a.error < std::abs(a.value) * kRelativeError &&
      b.error < std::abs(b.value) * kRelativeError) {
    return std::abs(a.value) / (std::abs(a.value) + std::abs(b.value));
  }
  return nearest_double(exact_parameter(s, o));
}

Rational RationalKernel::exact_parameter(LineId s, LineId o) const {
  const Rational from = cross(o, first_end(s)), to = cross(o, last_end(s));
  return from / (from - to);
}

int RationalKernel::compare_along(LineId s, LineId o, LineId q) const {
  return cmp(exact_parameter(s, o), exact_parameter(s, q));
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
  const Rational t = exact_parameter(s, o);
  return {c[0] + t * (c[2] - c[0]), c[1] + t * (c[3] - c[1])};
}

}  // namespace plumbline::bucket

#include "arrange/bucket/filtered_kernel.hpp"

#include <climits>
#include <cstdlib>
#include <tuple>
#include <utility>

namespace plumbline::bucket {
namespace {

using Weighted = ExactLines<mpz_class>::Line;

/// The median of a sample of values.
template <class Value, class At>
Value median_of(std::size_t count, At at) {
  constexpr std::size_t kSample = 1024;
  std::vector<Value> sample;
  const std::size_t size = std::min(count, kSample);
  for (std::size_t i = 0; i < size; ++i) sample.push_back(at(i * count / size));
  std::nth_element(sample.begin(), sample.begin() + static_cast<std::ptrdiff_t>(size / 2),
                   sample.end());
  return sample[size / 2];
}

/// Numerator and denominator of a number.
std::pair<mpz_class, mpz_class> fraction_of(const Number& n) {
  if (!n.is_decimal()) return {n.held_rational().get_num(), n.held_rational().get_den()};
  std::pair<mpz_class, mpz_class> f(static_cast<long>(n.mantissa()), 0);
  mpz_ui_pow_ui(f.second.get_mpz_t(), 10, static_cast<unsigned long>(n.digits()));
  return f;
}

/// The line with one denominator for its four coordinates, its first end first.
Weighted with_common_denominator(const std::array<const Number*, 4>& numbers) {
  std::array<mpz_class, 4> denominator;
  Weighted line;
  line[4] = 1;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    std::tie(line[k], denominator[k]) = fraction_of(*numbers[k]);
    if (mpz_divisible_p(line[4].get_mpz_t(), denominator[k].get_mpz_t()) == 0) {
      line[4] = lcm(line[4], denominator[k]);
    }
  }
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (denominator[k] != line[4]) line[k] *= line[4] / denominator[k];
  }
  if (line[0] > line[2] || (line[0] == line[2] && line[1] > line[3])) {
    std::swap(line[0], line[2]);
    std::swap(line[1], line[3]);
  }
  return line;
}

long bits(const mpz_class& z) { return static_cast<long>(mpz_sizeinbase(z.get_mpz_t(), 2)); }

/// All coordinates, and differences of two of them, are below this power of two.
long exponent_of(const std::vector<Weighted>& lines) {
  long exponent = LONG_MIN;
  for (const Weighted& line : lines) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (line[k] != 0) exponent = std::max(exponent, bits(line[k]) - bits(line[4]) + 2);
    }
  }
  return exponent == LONG_MIN ? 0 : exponent;
}

/// Coordinates less those of an origin, divided by a power of two.
class Rounding {
 public:
  Rounding(const Rational& x, const Rational& y, long exponent)
      : origin_{x, y}, exponent_(exponent) {}

  Approx approx(const Weighted& line) const {
    return {rounded(line, 0), rounded(line, 1), rounded(line, 2), rounded(line, 3)};
  }

 private:
  double rounded(const Weighted& line, std::size_t k) const {
    const Rational& o = origin_[k % 2];
    Rational c;  // not in lowest terms, which rounding needs not
    c.get_num() = line[k] * o.get_den() - o.get_num() * line[4];
    c.get_den() = line[4] * o.get_den();
    (exponent_ >= 0 ? c.get_den() : c.get_num()) <<= static_cast<mp_bitcnt_t>(std::abs(exponent_));
    return nearest_double(c);
  }

  std::array<Rational, 2> origin_;
  long exponent_;
};

}  // namespace

FilteredKernel::FilteredKernel(GridInput input, Job& job) : approx_(input.lines.size()) {
  const auto& lines = input.lines;
  if (!lines.empty()) {
    const Int128 x = median_of<Int128>(lines.size(), [&](std::size_t i) { return lines[i][0]; });
    const Int128 y = median_of<Int128>(lines.size(), [&](std::size_t i) { return lines[i][1]; });
    job.for_each(lines.size(), [&](std::size_t s) {
      approx_[s] = {static_cast<double>(lines[s][0] - x), static_cast<double>(lines[s][1] - y),
                    static_cast<double>(lines[s][2] - x), static_cast<double>(lines[s][3] - y)};
    });
  }
  exact_ = ExactLines<Int128>(std::move(input.lines), std::move(input.frame));
}

FilteredKernel::FilteredKernel(const SegmentSet& input, Job& job)
    : approx_(input.segments.size() + input.points.size()) {
  const std::vector<NumberPoint> points = numbers_of(input.points);
  std::vector<Weighted> lines(approx_.size());
  job.for_each(lines.size(), [&](std::size_t i) {
    std::array<const Number*, 4> numbers;
    for_numbers(input.segments, points, i,
                [&](std::size_t k, const Number& n) { numbers[k] = &n; });
    lines[i] = with_common_denominator(numbers);
  });
  if (!lines.empty()) {
    const auto coordinate = [&](std::size_t k) {
      return [&lines, k](std::size_t i) {
        Rational c(lines[i][k], lines[i][4]);
        c.canonicalize();
        return c;
      };
    };
    const Rounding rounding(median_of<Rational>(lines.size(), coordinate(0)),
                            median_of<Rational>(lines.size(), coordinate(1)), exponent_of(lines));
    job.for_each(lines.size(), [&](std::size_t s) { approx_[s] = rounding.approx(lines[s]); });
  }
  exact_ = ExactLines<mpz_class>(std::move(lines), {});
}

LineId FilteredKernel::join(EndId a, EndId b) {
  const PointD p = place(a), q = place(b);
  approx_.push_back({p.x, p.y, q.x, q.y});
  return std::visit([&](auto& exact) { return exact.join(a, b); }, exact_);
}

void FilteredKernel::resize(std::size_t size) {
  approx_.resize(size);
  std::visit([&](auto& exact) { exact.resize(size); }, exact_);
}

void FilteredKernel::reorder(const std::vector<LineId>& order, Job& job) {
  std::vector<Approx> approx(order.size());
  job.for_each(order.size(), [&](std::size_t i) { approx[i] = approx_[order[i]]; });
  approx_ = std::move(approx);
  std::visit([&](auto& exact) { exact.reorder(order, job); }, exact_);
}

void FilteredKernel::keys(std::size_t begin, std::size_t end, std::uint64_t* key) const {
  std::visit([&](const auto& exact) { exact.keys(begin, end, key); }, exact_);
}

double FilteredKernel::parameter(LineId s, LineId o) const {
  const Relation r = relate(s, o);
  return r.cross() ? r.at_s : exact_parameter(s, o);
}

int FilteredKernel::compare_directions(LineId s, LineId o) const {
  const Approx &l = approx_[s], &m = approx_[o];
  const double dx = l.bx - l.ax, dy = l.by - l.ay, ex = m.bx - m.ax, ey = m.by - m.ay;
  const double size = std::max({std::abs(dx), std::abs(dy), std::abs(ex), std::abs(ey)});
  const double error = error_of(size, std::max(reach(l), reach(m)));
  const double value = dx * ey - dy * ex;
  if (value > error) return 1;
  if (value < -error) return -1;
  return std::visit([&](const auto& exact) { return exact.compare_directions(s, o); }, exact_);
}

bool FilteredKernel::exact_is_point(LineId s) const {
  return std::visit([&](const auto& exact) { return exact.is_point(s); }, exact_);
}
int FilteredKernel::exact_side(LineId s, EndId end) const {
  return std::visit([&](const auto& exact) { return exact.side(s, end); }, exact_);
}
int FilteredKernel::exact_compare(EndId p, EndId q) const {
  return std::visit([&](const auto& exact) { return exact.compare(p, q); }, exact_);
}
int FilteredKernel::exact_compare_x(EndId p, EndId q) const {
  return std::visit([&](const auto& exact) { return exact.compare_x(p, q); }, exact_);
}
double FilteredKernel::exact_parameter(LineId s, LineId o) const {
  return std::visit([&](const auto& exact) { return exact.parameter(s, o); }, exact_);
}
int FilteredKernel::compare_along(LineId s, LineId o, LineId q) const {
  return std::visit([&](const auto& exact) { return exact.compare_along(s, o, q); }, exact_);
}
int FilteredKernel::side_of_crossing(LineId c, LineId s, LineId o) const {
  return std::visit([&](const auto& exact) { return exact.side_of_crossing(c, s, o); }, exact_);
}
int FilteredKernel::compare_x(LineId s, LineId o, EndId end) const {
  return std::visit([&](const auto& exact) { return exact.compare_x(s, o, end); }, exact_);
}
int FilteredKernel::compare_heights(LineId s, LineId o, EndId end) const {
  return std::visit([&](const auto& exact) { return exact.compare_heights(s, o, end); }, exact_);
}
LongPoint FilteredKernel::point(EndId end) const {
  return std::visit([&](const auto& exact) { return exact.point(end); }, exact_);
}
LongPoint FilteredKernel::crossing(LineId s, LineId o) const {
  return std::visit([&](const auto& exact) { return exact.crossing(s, o); }, exact_);
}

}  // namespace plumbline::bucket

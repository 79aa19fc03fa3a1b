#include "arrange/bucket/weighted_input.hpp"

#include <atomic>
#include <climits>
#include <optional>
#include <type_traits>
#include <utility>

#include "arrange/bucket/grid_input.hpp"
#include "arrange/bucket/median.hpp"

namespace plumbline::bucket {
namespace {

template <class C>
using Lines = std::vector<typename ExactLines<C>::Line>;
using AnyLine = ExactLines<mpz_class>::Line;

constexpr std::size_t kBlock = 1024;

/// Numerator and denominator of a number, to be read while that is there.
class Fraction {
 public:
  explicit Fraction(const Number& number) {
    if (number.is_decimal()) {
      const std::int64_t m = number.mantissa();
      size_ = static_cast<mp_limb_t>(m < 0 ? -m : m);
      power_ =
          static_cast<mp_limb_t>(wide::kPowersOfTen[static_cast<std::size_t>(number.digits())]);
      n_ = mpz_roinit_n(n_header_, &size_, m < 0 ? -1 : 1);
      d_ = mpz_roinit_n(d_header_, &power_, 1);
    } else {
      n_ = number.held_rational().get_num_mpz_t();
      d_ = number.held_rational().get_den_mpz_t();
    }
  }
  Fraction(const Fraction&) = delete;
  Fraction& operator=(const Fraction&) = delete;

  mpz_srcptr n() const { return n_; }
  mpz_srcptr d() const { return d_; }

 private:
  mp_limb_t size_ = 0, power_ = 1;
  mpz_t n_header_, d_header_;
  mpz_srcptr n_, d_;
};

/// Makes it the line with one denominator for its four coordinates, its first end first.
void set_line(AnyLine& line, const std::array<const Number*, 4>& numbers) {
  const std::array<Fraction, 4> fractions{Fraction(*numbers[0]), Fraction(*numbers[1]),
                                          Fraction(*numbers[2]), Fraction(*numbers[3])};
  const mpz_ptr weight = line[4].get_mpz_t();
  mpz_set(weight, fractions[0].d());
  for (const Fraction& f : fractions) {
    if (mpz_cmp(weight, f.d()) != 0) mpz_lcm(weight, weight, f.d());
  }
  for (std::size_t k = 0; k < fractions.size(); ++k) {
    const Fraction& f = fractions[k];
    const mpz_ptr v = line[k].get_mpz_t();
    if (mpz_cmp(weight, f.d()) == 0) {
      mpz_set(v, f.n());
    } else {
      mpz_divexact(v, weight, f.d());
      mpz_mul(v, v, f.n());
    }
  }
  if (line[0] > line[2] || (line[0] == line[2] && line[1] > line[3])) {
    std::swap(line[0], line[2]);
    std::swap(line[1], line[3]);
  }
}

bool fits(const AnyLine& line, const Words& /*in*/) {
  return std::all_of(line.begin(), line.end(), [](const mpz_class& v) {
    return mpz_sizeinbase(v.get_mpz_t(), 2) <= Arithmetic<Words>::kBits;
  });
}
bool fits(const AnyLine& /*line*/, const mpz_class& /*in*/) { return true; }

/// The lines of the input, then its points; nothing where one does not fit.
template <class C>
std::optional<Lines<C>> lines_of(const SegmentSet& input, Job& job) {
  const std::vector<NumberPoint> points = numbers_of(input.points);
  Lines<C> lines(input.segments.size() + points.size());
  std::atomic<bool> all_fit = true;
  job.for_blocks(lines.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    AnyLine line;  // one for all, so that each finds memory there
    for (std::size_t i = begin; i < end && all_fit.load(std::memory_order_relaxed); ++i) {
      std::array<const Number*, 4> numbers;
      for_numbers(input.segments, points, i,
                  [&](std::size_t k, const Number& n) { numbers[k] = &n; });
      set_line(line, numbers);
      if (fits(line, C())) {
        for (std::size_t k = 0; k < line.size(); ++k) lines[i][k] = C(line[k].get_mpz_t());
      } else {
        all_fit.store(false, std::memory_order_relaxed);
      }
    }
  });
  if (!all_fit) return std::nullopt;
  return lines;
}

/// An integer to be read while that is there.
class View {
 public:
  explicit View(const mpz_class& v) : z_(v.get_mpz_t()) {}
  explicit View(const Words& v) : z_(mpz_roinit_n(header_, v.words(), v.size())) {}
  View(const View&) = delete;
  View& operator=(const View&) = delete;
  operator mpz_srcptr() const { return z_; }

 private:
  mpz_t header_;
  mpz_srcptr z_;
};

/// All coordinates, and differences of two of them, are below this power of two.
template <class C>
long exponent_of(const Lines<C>& lines) {
  const auto bits = [](const C& v) { return static_cast<long>(mpz_sizeinbase(View(v), 2)); };
  long exponent = LONG_MIN;
  for (const auto& line : lines) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (sign(line[k]) != 0) exponent = std::max(exponent, bits(line[k]) - bits(line[4]) + 2);
    }
  }
  return exponent == LONG_MIN ? 0 : exponent;
}

/// Rounds coordinates less those of an origin, divided by a power of two.
class Rounding {
 public:
  /// Requires: the denominator is a power of two.
  Rounding(const Rational& origin, long exponent)
      : n_(origin.get_num()),
        shift_(mpz_sizeinbase(origin.get_den_mpz_t(), 2) - 1),
        up_(exponent < 0 ? static_cast<mp_bitcnt_t>(-exponent) : 0),
        down_(exponent > 0 ? static_cast<mp_bitcnt_t>(exponent) : 0) {}

  /// Of v / weight.
  double operator()(mpz_srcptr v, mpz_srcptr weight) {
    const mpz_ptr n = value_.get_num_mpz_t(), d = value_.get_den_mpz_t();
    mpz_mul_2exp(n, v, shift_);
    mpz_submul(n, weight, n_.get_mpz_t());
    if (up_ != 0) mpz_mul_2exp(n, n, up_);
    mpz_mul_2exp(d, weight, shift_ + down_);
    return nearest_double(value_);  // not in lowest terms, which it need not be
  }

 private:
  mpz_class n_;
  mp_bitcnt_t shift_, up_, down_;
  Rational value_;
};

template <class C>
std::vector<Approx> approximations(const Lines<C>& lines, Job& job) {
  std::vector<Approx> approx(lines.size());
  if (lines.empty()) return approx;
  const auto middle = [&](std::size_t k) {
    Rounding rounding(0, 0);
    return Rational(median_of<double>(lines.size(), [&](std::size_t i) {
      return rounding(View(lines[i][k]), View(lines[i][4]));
    }));
  };
  const Rational x = middle(0), y = middle(1);
  const long exponent = exponent_of<C>(lines);
  job.for_blocks(lines.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    Rounding round_x(x, exponent), round_y(y, exponent);
    for (std::size_t i = begin; i < end; ++i) {
      const auto& line = lines[i];
      const View weight(line[4]);
      approx[i] = {round_x(View(line[0]), weight), round_y(View(line[1]), weight),
                   round_x(View(line[2]), weight), round_y(View(line[3]), weight)};
    }
  });
  return approx;
}

template <class C>
WeightedInput input_of(Lines<C> lines, Job& job) {
  std::vector<Approx> approx = approximations<C>(lines, job);
  return {ExactLines<C>(std::move(lines), {}), std::move(approx)};
}

}  // namespace

WeightedInput WeightedInput::from(const SegmentSet& input, Job& job) {
  if (auto lines = lines_of<Words>(input, job)) return input_of<Words>(*std::move(lines), job);
  return input_of<mpz_class>(*lines_of<mpz_class>(input, job), job);
}

ExactLines<mpz_class> of_any_size(const ExactLines<Words>& lines) {
  Lines<mpz_class> result(lines.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto& line = lines[static_cast<LineId>(i)];
    for (std::size_t k = 0; k < line.size(); ++k) result[i][k] = to_mpz(line[k]);
  }
  return {std::move(result), {}};
}

}  // namespace plumbline::bucket

#include "arrange/bucket/grid_input.hpp"

#include <algorithm>
#include <atomic>

#include "arrange/bucket/wide.hpp"

namespace plumbline::bucket {
namespace {

constexpr std::size_t kBlock = 2048;

/// Scales below this fit, and distances from the first coordinate.
constexpr int kDistanceBits = GridInput::kBits + 1;
const mpz_class& bound() {
  static const mpz_class value = mpz_class(1) << kDistanceBits;
  return value;
}

/// The least common multiple of all denominators, or nothing if it is not below the bound.
std::optional<mpz_class> common_scale(const SegmentSet& input) {
  mpz_class scale = 1;
  const auto include = [&](const Rational& c) {
    if (mpz_divisible_p(scale.get_mpz_t(), c.get_den_mpz_t()) == 0) {
      mpz_lcm(scale.get_mpz_t(), scale.get_mpz_t(), c.get_den_mpz_t());
    }
    return scale < bound();
  };
  for (const Segment& s : input.segments) {
    if (!include(s.a.x) || !include(s.a.y) || !include(s.b.x) || !include(s.b.y))
      return std::nullopt;
  }
  for (const Point& p : input.points) {
    if (!include(p.x) || !include(p.y)) return std::nullopt;
  }
  return scale;
}

/// c times scale, an integer, less the origin, in `result`; false if it does not fit.
bool on_grid(const Rational& c, const mpz_class& scale, const mpz_class& origin, mpz_class& work,
             std::int64_t& result) {
  mpz_divexact(work.get_mpz_t(), scale.get_mpz_t(), c.get_den_mpz_t());
  mpz_mul(work.get_mpz_t(), work.get_mpz_t(), c.get_num_mpz_t());
  work -= origin;
  if (mpz_cmpabs(work.get_mpz_t(), bound().get_mpz_t()) >= 0) return false;
  result = work.get_si();
  return true;
}

void orient(std::array<std::int64_t, 4>& line) {
  if (line[0] > line[2] || (line[0] == line[2] && line[1] > line[3])) {
    std::swap(line[0], line[2]);
    std::swap(line[1], line[3]);
  }
}

/// The isolated points as numbers.
std::vector<NumberPoint> numbers_of(const std::vector<Point>& points) {
  std::vector<NumberPoint> result;
  result.reserve(points.size());
  for (const Point& p : points) result.push_back({Number(p.x), Number(p.y)});
  return result;
}

/// Calls visit(i, k, number) for coordinate k of segment i; those of points come after, twice.
template <class Visit>
void for_numbers(const SegmentList& segments, const std::vector<NumberPoint>& points, std::size_t i,
                 Visit visit) {
  if (i < segments.size()) {
    const auto numbers = segments.numbers(i);
    for (std::size_t k = 0; k < numbers.size(); ++k) visit(k, numbers[k]);
  } else {
    const NumberPoint& p = points[i - segments.size()];
    visit(0, p.x);
    visit(1, p.y);
    visit(2, p.x);
    visit(3, p.y);
  }
}

/// Short decimals on the grid of their last digits; false if that does not hold them all.
bool decimals_on_grid(const SegmentSet& input, const Point& first, GridInput& grid, Job& job) {
  const std::vector<NumberPoint> points = numbers_of(input.points);
  int digits = 0;
  bool short_decimals = true;
  for (std::size_t i = 0; i < grid.lines.size() && short_decimals; ++i) {
    for_numbers(input.segments, points, i, [&](std::size_t, const Number& n) {
      short_decimals = short_decimals && n.is_decimal();
      digits = std::max(digits, n.digits());
    });
  }
  if (!short_decimals) return false;
  std::array<std::int64_t, Number::kMaxDigits + 1> power{1};
  for (std::size_t d = 1; d < power.size(); ++d) power[d] = 10 * power[d - 1];
  const auto scaled = [&](const Number& n) {
    return Int128(n.mantissa()) * power[static_cast<std::size_t>(digits - n.digits())];
  };
  const Int128 origin[2] = {scaled(Number(first.x)), scaled(Number(first.y))};
  std::atomic<bool> fits = true;
  job.for_each(grid.lines.size(), [&](std::size_t i) {
    for_numbers(input.segments, points, i, [&](std::size_t k, const Number& n) {
      const Int128 v = scaled(n) - origin[k % 2];
      if (v >= Int128(1) << kDistanceBits || -v >= Int128(1) << kDistanceBits) {
        fits.store(false, std::memory_order_relaxed);
      }
      grid.lines[i][k] = static_cast<std::int64_t>(v);
    });
    orient(grid.lines[i]);
  });
  grid.scale = static_cast<unsigned long>(power[static_cast<std::size_t>(digits)]);
  return fits;
}

/// Any rationals on the grid of their common denominator; false if that does not hold them all.
bool rationals_on_grid(const SegmentSet& input, const Point& first, GridInput& grid, Job& job) {
  const std::optional<mpz_class> scale = common_scale(input);
  if (!scale) return false;
  grid.scale = *scale;
  const mpz_class x = Rational(first.x * *scale).get_num(),
                  y = Rational(first.y * *scale).get_num();
  const std::size_t segments = input.segments.size();
  std::atomic<bool> fits = true;
  job.for_blocks(grid.lines.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    mpz_class work;
    for (std::size_t i = begin; i < end && fits; ++i) {
      auto& line = grid.lines[i];
      const auto [a, b] = i < segments
                              ? input.segments[i]
                              : Segment{input.points[i - segments], input.points[i - segments]};
      if (!on_grid(a.x, *scale, x, work, line[0]) || !on_grid(a.y, *scale, y, work, line[1]) ||
          !on_grid(b.x, *scale, x, work, line[2]) || !on_grid(b.y, *scale, y, work, line[3])) {
        fits = false;
      }
      orient(line);
    }
  });
  return fits;
}

/// Moves the origin to the middle, so that coordinates are as small as they can be.
void centre(const Point& first, GridInput& grid, Job& job) {
  auto low = grid.lines[0], high = low;
  for (const auto& line : grid.lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      low[i] = std::min(low[i], line[i]);
      high[i] = std::max(high[i], line[i]);
    }
  }
  const auto middle = [&](std::size_t i) {
    const std::int64_t least = std::min(low[i], low[i + 2]), most = std::max(high[i], high[i + 2]);
    const std::int64_t m = least + (most - least) / 2;
    grid.largest = std::max({grid.largest, m - least, most - m});
    return m;
  };
  const std::int64_t x = middle(0), y = middle(1);
  job.for_each(grid.lines.size(), [&](std::size_t i) {
    auto& line = grid.lines[i];
    line[0] -= x;
    line[2] -= x;
    line[1] -= y;
    line[3] -= y;
  });
  grid.x = Rational(first.x * grid.scale).get_num() + static_cast<long>(x);
  grid.y = Rational(first.y * grid.scale).get_num() + static_cast<long>(y);
}

}  // namespace

std::optional<GridInput> GridInput::from(const SegmentSet& input, Job& job) {
  GridInput grid;
  grid.lines.resize(input.segments.size() + input.points.size());
  if (grid.lines.empty()) return grid;
  const Point first = input.segments.empty() ? input.points[0] : input.segments[0].a;
  if (!decimals_on_grid(input, first, grid, job) && !rationals_on_grid(input, first, grid, job)) {
    return std::nullopt;
  }
  centre(first, grid, job);
  if ((grid.largest >> kBits) != 0) return std::nullopt;
  return grid;
}

}  // namespace plumbline::bucket

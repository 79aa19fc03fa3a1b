#include "arrange/bucket/grid_input.hpp"

#include <algorithm>
#include <atomic>

#include "arrange/bucket/wide.hpp"

namespace plumbline::bucket {
namespace {

constexpr std::size_t kBlock = 2048;

/// Coordinates of absolute value below this fit the grid.
const mpz_class& bound() {
  static const mpz_class value = mpz_class(1) << GridInput::kBits;
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

/// c times scale, an integer, in `result`; false if it does not fit.
bool on_grid(const Rational& c, const mpz_class& scale, mpz_class& work, std::int64_t& result) {
  mpz_divexact(work.get_mpz_t(), scale.get_mpz_t(), c.get_den_mpz_t());
  mpz_mul(work.get_mpz_t(), work.get_mpz_t(), c.get_num_mpz_t());
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

/// The most digits after the point; nothing if there are other than short decimals.
std::optional<int> most_digits(const SegmentList& segments) {
  int most = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (const Number& n : segments.numbers(i)) {
      if (!n.is_decimal()) return std::nullopt;
      most = std::max(most, n.digits());
    }
  }
  return most;
}

/// Short decimals on the grid of their last digits; false if that does not hold them all.
bool decimals_on_grid(const SegmentList& segments, GridInput& grid, Job& job) {
  const std::optional<int> digits = most_digits(segments);
  if (!digits) return false;
  std::array<std::int64_t, Number::kMaxDigits + 1> power{1};
  for (std::size_t d = 1; d < power.size(); ++d) power[d] = 10 * power[d - 1];
  std::atomic<bool> fits = true;
  job.for_each(segments.size(), [&](std::size_t i) {
    const auto numbers = segments.numbers(i);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const Int128 v = Int128(numbers[k].mantissa()) *
                       power[static_cast<std::size_t>(*digits - numbers[k].digits())];
      if (v >= Int128(1) << GridInput::kBits || -v >= Int128(1) << GridInput::kBits) {
        fits.store(false, std::memory_order_relaxed);
      }
      grid.lines[i][k] = static_cast<std::int64_t>(v);
    }
    orient(grid.lines[i]);
  });
  grid.scale = static_cast<unsigned long>(power[static_cast<std::size_t>(*digits)]);
  return fits;
}

/// Any rationals on the grid of their common denominator; false if that does not hold them all.
bool rationals_on_grid(const SegmentSet& input, GridInput& grid, Job& job) {
  const std::optional<mpz_class> scale = common_scale(input);
  if (!scale) return false;
  grid.scale = *scale;
  const std::size_t segments = input.segments.size();
  std::atomic<bool> fits = true;
  job.for_blocks(grid.lines.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    mpz_class work;
    for (std::size_t i = begin; i < end && fits; ++i) {
      auto& line = grid.lines[i];
      const auto [a, b] = i < segments
                              ? input.segments[i]
                              : Segment{input.points[i - segments], input.points[i - segments]};
      if (!on_grid(a.x, *scale, work, line[0]) || !on_grid(a.y, *scale, work, line[1]) ||
          !on_grid(b.x, *scale, work, line[2]) || !on_grid(b.y, *scale, work, line[3])) {
        fits = false;
      }
      orient(line);
    }
  });
  return fits;
}

/// Moves the origin to the middle, so that coordinates are as small as they can be.
void centre(GridInput& grid, Job& job) {
  if (grid.lines.empty()) return;
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
  grid.x = middle(0);
  grid.y = middle(1);
  job.for_each(grid.lines.size(), [&](std::size_t i) {
    auto& line = grid.lines[i];
    line[0] -= grid.x;
    line[2] -= grid.x;
    line[1] -= grid.y;
    line[3] -= grid.y;
  });
}

}  // namespace

std::optional<GridInput> GridInput::from(const SegmentSet& input, Job& job) {
  GridInput grid;
  grid.lines.resize(input.segments.size() + input.points.size());
  const bool fits = (input.points.empty() && decimals_on_grid(input.segments, grid, job)) ||
                    rationals_on_grid(input, grid, job);
  if (!fits) return std::nullopt;
  centre(grid, job);
  return grid;
}

}  // namespace plumbline::bucket

#include "arrange/bucket/grid_input.hpp"

#include <algorithm>
#include <atomic>

namespace plumbline::bucket {
namespace {

/// Scales and multiples of it are below this, and so are distances from the first coordinate.
constexpr int kDistanceBits = GridInput::kBits + 1;
constexpr UInt128 kBound = UInt128{1} << kDistanceBits;

bool is_below_bound(const mpz_class& v) {
  return mpz_sizeinbase(v.get_mpz_t(), 2) <= kDistanceBits;
}

mpz_class power_of_ten(int digits) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(digits));
  return power;
}

/// The least common multiple of all denominators, or nothing if it is not below the bound.
std::optional<mpz_class> common_scale(const SegmentSet& input,
                                      const std::vector<NumberPoint>& points, std::size_t count) {
  mpz_class scale = 1;
  int digits = 0;
  bool fits = true;
  for (std::size_t i = 0; i < count && fits; ++i) {
    for_numbers(input.segments, points, i, [&](std::size_t, const Number& n) {
      if (n.is_decimal()) {
        digits = std::max(digits, n.digits());
        return;
      }
      const mpz_class& d = n.held_rational().get_den();
      if (mpz_divisible_p(scale.get_mpz_t(), d.get_mpz_t()) == 0) scale = lcm(scale, d);
      fits = fits && is_below_bound(scale);
    });
  }
  scale = lcm(scale, power_of_ten(digits));
  if (!fits || !is_below_bound(scale)) return std::nullopt;
  return scale;
}

/// Numbers as integers on the grid, counted from a point of it.
class Grid {
 public:
  Grid(const mpz_class& scale, const Number& x, const Number& y) : scale_(scale) {
    for (int d = 0; d <= Number::kMaxDigits; ++d) {
      const mpz_class power = power_of_ten(d);
      if (mpz_divisible_p(scale.get_mpz_t(), power.get_mpz_t()) == 0) break;
      per_decimal_.push_back(magnitude(to_int256(scale / power)).low);
    }
    const auto origin_x = on_grid(x), origin_y = on_grid(y);
    if (origin_x && origin_y) origin_ = {*origin_x, *origin_y};
  }
  /// From the point of the grid; 0 stands for one that is too far from 0.
  const std::array<Int256, 2>& origin() const { return origin_; }

  /// Coordinate k of a line; nothing where it is not below the bound.
  std::optional<Int128> at(std::size_t k, const Number& n) const {
    const std::optional<Int256> absolute = on_grid(n);
    if (!absolute) return std::nullopt;
    const Int256 v = *absolute - origin_[k % 2];
    const UInt256 m = magnitude(v);
    if (m.high != 0 || m.low >= kBound) return std::nullopt;
    return static_cast<Int128>(v.low);
  }

 private:
  /// Nothing if it has more than 250 bits.
  std::optional<Int256> on_grid(const Number& n) const {
    if (n.is_decimal()) {
      const UInt256 m = multiply(magnitude(Int128(n.mantissa())),
                                 per_decimal_[static_cast<std::size_t>(n.digits())]);
      const Int256 v(static_cast<Int128>(m.high), m.low);
      return n.mantissa() < 0 ? -v : v;
    }
    const Rational& r = n.held_rational();
    mpz_class v;
    mpz_divexact(v.get_mpz_t(), scale_.get_mpz_t(), r.get_den_mpz_t());
    v *= r.get_num();
    if (mpz_sizeinbase(v.get_mpz_t(), 2) > 250) return std::nullopt;
    return to_int256(v);
  }

  mpz_class scale_;
  std::vector<UInt128> per_decimal_;  ///< grid units in 10^-d
  std::array<Int256, 2> origin_;
};

void orient(std::array<Int128, 4>& line) {
  if (line[0] > line[2] || (line[0] == line[2] && line[1] > line[3])) {
    std::swap(line[0], line[2]);
    std::swap(line[1], line[3]);
  }
}

/// False where a coordinate does not fit.
bool fill(const SegmentSet& input, const std::vector<NumberPoint>& points, const Grid& on_grid,
          GridInput& grid, Job& job) {
  std::atomic<bool> fits = true;
  job.for_each(grid.lines.size(), [&](std::size_t i) {
    for_numbers(input.segments, points, i, [&](std::size_t k, const Number& n) {
      const std::optional<Int128> v = on_grid.at(k, n);
      if (!v) fits.store(false, std::memory_order_relaxed);
      grid.lines[i][k] = v.value_or(0);
    });
    orient(grid.lines[i]);
  });
  return fits;
}

/// Moves the origin to the middle, so that coordinates are as small as they can be.
void centre(GridInput& grid, Job& job) {
  auto low = grid.lines[0], high = low;
  for (const auto& line : grid.lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      low[i] = std::min(low[i], line[i]);
      high[i] = std::max(high[i], line[i]);
    }
  }
  const auto middle = [&](std::size_t i) {
    const Int128 least = std::min(low[i], low[i + 2]), most = std::max(high[i], high[i + 2]);
    const Int128 m = least + (most - least) / 2;
    grid.largest = std::max({grid.largest, m - least, most - m});
    return m;
  };
  const Int128 x = middle(0), y = middle(1);
  job.for_each(grid.lines.size(), [&](std::size_t i) {
    auto& line = grid.lines[i];
    line[0] -= x;
    line[2] -= x;
    line[1] -= y;
    line[3] -= y;
  });
  grid.frame.x += to_mpz(x);
  grid.frame.y += to_mpz(y);
}

}  // namespace

std::vector<NumberPoint> numbers_of(const std::vector<Point>& points) {
  std::vector<NumberPoint> result;
  result.reserve(points.size());
  for (const Point& p : points) result.push_back({Number(p.x), Number(p.y)});
  return result;
}

std::optional<GridInput> GridInput::from(const SegmentSet& input, Job& job) {
  const std::vector<NumberPoint> points = numbers_of(input.points);
  GridInput grid;
  grid.lines.resize(input.segments.size() + points.size());
  if (grid.lines.empty()) return grid;
  const std::optional<mpz_class> scale = common_scale(input, points, grid.lines.size());
  if (!scale) return std::nullopt;
  grid.frame.scale = *scale;
  std::array<Number, 2> first;
  for_numbers(input.segments, points, 0, [&](std::size_t k, const Number& n) { first[k % 2] = n; });
  const Grid on_grid(*scale, first[0], first[1]);
  if (!fill(input, points, on_grid, grid, job)) return std::nullopt;
  grid.frame.x = to_mpz(on_grid.origin()[0]);
  grid.frame.y = to_mpz(on_grid.origin()[1]);
  centre(grid, job);
  if ((grid.largest >> kBits) != 0) return std::nullopt;
  return grid;
}

}  // namespace plumbline::bucket

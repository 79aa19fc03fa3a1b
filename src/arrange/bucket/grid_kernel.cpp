#include "arrange/bucket/grid_kernel.hpp"

#include <atomic>

#include "arrange/bucket/prime_field.hpp"

namespace plumbline::bucket {
namespace {

constexpr std::size_t kBlock = 2048;

/// Coordinates of absolute value below this fit the grid.
const mpz_class& bound() {
  static const mpz_class value = mpz_class(1) << GridInput::kBits;
  return value;
}

mpz_class to_mpz(Int128 v) {
  const UInt128 m = static_cast<UInt128>(v < 0 ? -v : v);
  mpz_class result = static_cast<unsigned long>(m >> 64);
  result <<= 64;
  result += static_cast<unsigned long>(static_cast<std::uint64_t>(m));
  return v < 0 ? mpz_class(-result) : result;
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

template <class C>
GridKernel<C>::GridKernel(const GridInput& input)
    : lines_(input.lines.size()), scale_(input.scale), middle_x_(input.x), middle_y_(input.y) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    for (std::size_t k = 0; k < lines_[i].size(); ++k) {
      lines_[i][k] = static_cast<C>(input.lines[i][k]);
    }
  }
}

template <class C>
LineId GridKernel<C>::join(EndId a, EndId b) {
  lines_.push_back({x(a), y(a), x(b), y(b)});
  return static_cast<LineId>(lines_.size() - 1);
}

template <class C>
void GridKernel<C>::reorder(const std::vector<LineId>& order, Job& job) {
  std::vector<Coordinates> lines(order.size());
  job.for_each(order.size(), [&](std::size_t i) { lines[i] = lines_[order[i]]; });
  lines_ = std::move(lines);
}

// The supporting line is y = slope x + height with slope = dy / dx and height = ay - slope ax; all
// divisions of a block are made with one inversion (Montgomery 1987).
template <class C>
void GridKernel<C>::keys(std::size_t begin, std::size_t end, std::uint64_t* key) const {
  namespace field = prime_field;
  const auto dx = [&](std::size_t s) {
    return field::residue(std::int64_t(lines_[s][2]) - lines_[s][0]);
  };
  std::uint64_t product = 1;
  for (std::size_t s = begin; s < end; ++s) {
    key[s - begin] = product;
    // |dx| < 2^61 - 1, so its residue is 0 only for 0.
    if (const std::uint64_t d = dx(s); d != 0) product = field::multiply(product, d);
  }
  std::uint64_t inverse = field::inverse(product);
  for (std::size_t s = end; s-- > begin;) {
    const Coordinates& c = lines_[s];
    const std::uint64_t ax = field::residue(c[0]), ay = field::residue(c[1]);
    std::uint64_t& k = key[s - begin];
    if (const std::uint64_t d = dx(s); d != 0) {
      const std::uint64_t dy = field::residue(std::int64_t(c[3]) - c[1]);
      const std::uint64_t slope = field::multiply(dy, field::multiply(inverse, k));
      inverse = field::multiply(inverse, d);
      k = field::key(slope, field::subtract(ay, field::multiply(slope, ax)));
    } else if (c[1] != c[3]) {
      k = field::key(field::kVertical, ax);
    } else {
      k = field::key(field::kPoint, field::key(ax, ay));
    }
  }
}

template <class C>
auto GridKernel<C>::fraction(LineId s, LineId o) const -> std::pair<Wide, Wide> {
  const Wide from = cross(o, first_end(s)), to = cross(o, last_end(s));
  return from > to ? std::pair<Wide, Wide>(from, from - to)
                   : std::pair<Wide, Wide>(-from, to - from);
}

template <class C>
int GridKernel<C>::compare_along(LineId s, LineId o, LineId q) const {
  const auto [n, d] = fraction(s, o);
  const auto [m, e] = fraction(s, q);
  return compare_products(n, e, m, d);
}

// The orientation of c's ends and a point of s is linear along s, so at the crossing it has the
// sign of (1 - n/d) A + n/d B with its values A, B at the ends of s.
template <class C>
int GridKernel<C>::side_of_crossing(LineId c, LineId s, LineId o) const {
  const auto [n, d] = fraction(s, o);
  return compare_products(cross(c, first_end(s)), Wide(d - n), Wide(-cross(c, last_end(s))), n);
}

template <class C>
int GridKernel<C>::compare_x(LineId s, LineId o, EndId end) const {
  const auto [n, d] = fraction(s, o);
  return compare_products(n, Wide(lines_[s][2]) - lines_[s][0], d, Wide(x(end)) - lines_[s][0]);
}

// Height of s at x: ay + dy (x - ax) / dx. With h = dx ay + dy (x - ax), of at most 2 kBits + 3
// bits, heights are h / dx.
template <class C>
int GridKernel<C>::compare_heights(LineId s, LineId o, EndId end) const {
  const auto height = [&](LineId line) {
    const Coordinates& c = lines_[line];
    const Wide dx = Wide(c[2]) - c[0];
    return std::pair<Wide, Wide>(dx * c[1] + (Wide(c[3]) - c[1]) * (Wide(x(end)) - c[0]), dx);
  };
  const auto [h, dx] = height(s);
  const auto [k, ex] = height(o);
  const int by_height = compare_products(h, ex, k, dx);
  return by_height != 0 ? by_height : -compare_directions(s, o);
}

template <class C>
Point GridKernel<C>::point(EndId end) const {
  Point p{Rational(mpz_class(std::int64_t(x(end)) + middle_x_), scale_),
          Rational(mpz_class(std::int64_t(y(end)) + middle_y_), scale_)};
  p.x.canonicalize();
  p.y.canonicalize();
  return p;
}

template <class C>
Point GridKernel<C>::crossing(LineId s, LineId o) const {
  const auto [n, d] = fraction(s, o);
  const Coordinates& c = lines_[s];
  const mpz_class numerator = to_mpz(n), denominator = to_mpz(d);
  const auto at = [&](std::int64_t a, std::int64_t b, std::int64_t middle) {
    Rational r(mpz_class(a + middle) * denominator + mpz_class(b - a) * numerator,
               denominator * scale_);
    r.canonicalize();
    return r;
  };
  return {at(c[0], c[2], middle_x_), at(c[1], c[3], middle_y_)};
}

template class GridKernel<std::int32_t>;
template class GridKernel<std::int64_t>;

}  // namespace plumbline::bucket

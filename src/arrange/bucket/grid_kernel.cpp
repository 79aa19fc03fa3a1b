#include "arrange/bucket/grid_kernel.hpp"

namespace plumbline::bucket {
namespace {

/// Coordinates of absolute value below this fit the grid.
const mpz_class& bound() {
  static const mpz_class value = mpz_class(1) << GridKernel::kBits;
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

/// c times scale, an integer; nothing if it does not fit.
std::optional<std::int64_t> on_grid(const Rational& c, const mpz_class& scale, mpz_class& work) {
  mpz_divexact(work.get_mpz_t(), scale.get_mpz_t(), c.get_den_mpz_t());
  work *= c.get_num();
  if (mpz_cmpabs(work.get_mpz_t(), bound().get_mpz_t()) >= 0) return std::nullopt;
  return work.get_si();
}

}  // namespace

std::optional<GridKernel> GridKernel::from(const SegmentSet& input) {
  const std::optional<mpz_class> scale = common_scale(input);
  if (!scale) return std::nullopt;
  GridKernel kernel;
  kernel.scale_ = *scale;
  kernel.lines_.reserve(input.segments.size() + input.points.size());
  for (const Segment& s : input.segments) {
    const bool forward = s.a < s.b;
    if (!kernel.add(forward ? s.a : s.b, forward ? s.b : s.a)) return std::nullopt;
  }
  for (const Point& p : input.points) {
    if (!kernel.add(p, p)) return std::nullopt;
  }
  return kernel;
}

bool GridKernel::add(const Point& a, const Point& b) {
  Coordinates line;
  const std::array<const Rational*, 4> coordinates{&a.x, &a.y, &b.x, &b.y};
  mpz_class work;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::optional<std::int64_t> c = on_grid(*coordinates[i], scale_, work);
    if (!c) return false;
    line[i] = *c;
  }
  lines_.push_back(line);
  return true;
}

void GridKernel::reorder(const std::vector<LineId>& order) {
  std::vector<Coordinates> lines;
  lines.reserve(order.size());
  for (const LineId s : order) lines.push_back(lines_[s]);
  lines_ = std::move(lines);
}

std::pair<Int128, Int128> GridKernel::parameter(LineId s, LineId o) const {
  const Int128 from = cross(o, first_end(s)), to = cross(o, last_end(s));
  return from > to ? std::pair(from, from - to) : std::pair(-from, to - from);
}

int GridKernel::compare_along(LineId s, LineId o, LineId q) const {
  const auto [n, d] = parameter(s, o);
  const auto [m, e] = parameter(s, q);
  return compare_products(n, e, m, d);
}

// The orientation of c's ends and a point of s is linear along s, so at the crossing it has the
// sign of (1 - n/d) A + n/d B with its values A, B at the ends of s.
int GridKernel::side_of_crossing(LineId c, LineId s, LineId o) const {
  const auto [n, d] = parameter(s, o);
  return compare_products(cross(c, first_end(s)), d - n, -cross(c, last_end(s)), n);
}

int GridKernel::compare_x(LineId s, LineId o, EndId end) const {
  const auto [n, d] = parameter(s, o);
  return compare_products(n, lines_[s][2] - lines_[s][0], d, Int128(x(end)) - lines_[s][0]);
}

// Height of s at x: ay + dy (x - ax) / dx. With h = dx ay + dy (x - ax), of at most 2 kBits + 3
// bits, heights are h / dx.
int GridKernel::compare_heights(LineId s, LineId o, EndId end) const {
  const auto height = [&](LineId line) {
    const Coordinates& c = lines_[line];
    const Int128 dx = c[2] - c[0];
    return std::pair(dx * c[1] + Int128(c[3] - c[1]) * (x(end) - c[0]), dx);
  };
  const auto [h, dx] = height(s);
  const auto [k, ex] = height(o);
  const int by_height = compare_products(h, ex, k, dx);
  return by_height != 0 ? by_height : -compare_directions(s, o);
}

Point GridKernel::point(EndId end) const {
  Point p{Rational(mpz_class(x(end)), scale_), Rational(mpz_class(y(end)), scale_)};
  p.x.canonicalize();
  p.y.canonicalize();
  return p;
}

Point GridKernel::crossing(LineId s, LineId o) const {
  const auto [n, d] = parameter(s, o);
  const Coordinates& c = lines_[s];
  const mpz_class numerator = to_mpz(n), denominator = to_mpz(d);
  Point p{Rational(mpz_class(c[0]) * denominator + mpz_class(c[2] - c[0]) * numerator,
                   denominator * scale_),
          Rational(mpz_class(c[1]) * denominator + mpz_class(c[3] - c[1]) * numerator,
                   denominator * scale_)};
  p.x.canonicalize();
  p.y.canonicalize();
  return p;
}

}  // namespace plumbline::bucket

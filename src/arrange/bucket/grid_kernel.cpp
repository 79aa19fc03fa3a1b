#include "arrange/bucket/grid_kernel.hpp"

#include "arrange/bucket/prime_field.hpp"

namespace plumbline::bucket {
namespace {

mpz_class to_mpz(Int128 v) {
  const UInt128 m = static_cast<UInt128>(v < 0 ? -v : v);
  mpz_class result = static_cast<unsigned long>(m >> 64);
  result <<= 64;
  result += static_cast<unsigned long>(static_cast<std::uint64_t>(m));
  return v < 0 ? mpz_class(-result) : result;
}

}  // namespace

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
  Point p{Rational(mpz_class(static_cast<long>(x(end)) + middle_x_), scale_),
          Rational(mpz_class(static_cast<long>(y(end)) + middle_y_), scale_)};
  p.x.canonicalize();
  p.y.canonicalize();
  return p;
}

template <class C>
Point GridKernel<C>::crossing(LineId s, LineId o) const {
  const auto [n, d] = fraction(s, o);
  const Coordinates& c = lines_[s];
  const mpz_class numerator = to_mpz(n), denominator = to_mpz(d);
  const auto at = [&](long a, long b, const mpz_class& middle) {
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

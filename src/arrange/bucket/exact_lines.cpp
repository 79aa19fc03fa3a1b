#include "arrange/bucket/exact_lines.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "arrange/bucket/prime_field.hpp"

namespace plumbline::bucket {
namespace {

namespace field = prime_field;

/// n / d as a double, with an error of some roundings.
double quotient(const mpz_class& n, const mpz_class& d) {
  long n_exponent = 0, d_exponent = 0;
  const double a = mpz_get_d_2exp(&n_exponent, n.get_mpz_t());
  const double b = mpz_get_d_2exp(&d_exponent, d.get_mpz_t());
  return std::ldexp(a / b, static_cast<int>(std::max(n_exponent - d_exponent, -2000L)));
}
template <int N>
double quotient(const FixedInteger<N>& n, const FixedInteger<N>& d) {
  return quotient(to_mpz(n), to_mpz(d));
}
template <class Integer>
double quotient(const Integer& n, const Integer& d) {
  return to_double(n) / to_double(d);
}

std::uint64_t residue(std::int64_t v) { return field::residue(v); }
std::uint64_t residue(Int128 v) {
  const UInt128 m = magnitude(v);  // 2^64 = 8
  const std::uint64_t r =
      field::reduced(field::reduced(static_cast<std::uint64_t>(m)) +
                     field::multiply(8, field::reduced(static_cast<std::uint64_t>(m >> 64))));
  return v < 0 ? field::subtract(0, r) : r;
}
template <int N>
std::uint64_t residue(const FixedInteger<N>& v) {
  std::uint64_t r = 0;
  for (int i = v.length(); i-- > 0;) {
    r = field::reduced(field::multiply(8, r) + field::reduced(v.words()[i]));  // 2^64 = 8
  }
  return v.size() < 0 ? field::subtract(0, r) : r;
}
std::uint64_t residue(const mpz_class& v) { return mpz_fdiv_ui(v.get_mpz_t(), field::kPrime); }
/// Of a rational in lowest terms; kNoResidue if it has none.
std::uint64_t residue(const Rational& value) {
  const std::uint64_t d = residue(value.get_den());
  return d == 0 ? field::kNoResidue : field::multiply(residue(value.get_num()), field::inverse(d));
}

/// The same integer in a type whose products are those that points need.
template <class Factor, class Integer>
Factor factor(const Integer& v) {
  if constexpr (std::is_same_v<Integer, Int256>) {
    return Factor(magnitude(v), sign(v) < 0);
  } else if constexpr (std::is_same_v<Integer, mpz_class> && !std::is_same_v<Factor, mpz_class>) {
    return Factor(v.get_mpz_t());
  } else {
    return Factor(v);
  }
}

Rational quotient_of(const mpz_class& n, const mpz_class& d) {
  Rational r(n, d);
  r.canonicalize();
  return r;
}

}  // namespace

template <class C>
LineId ExactLines<C>::join(EndId a, EndId b) {
  Line joined{x(a), y(a), x(b), y(b)};
  if constexpr (kWeighted) {
    joined[4] = lines_[line_of(a)][4];
    if (!have_one_weight(line_of(a), line_of(b))) {
      joined = {C(weighted(x(a), b)), C(weighted(y(a), b)), C(weighted(x(b), a)),
                C(weighted(y(b), a)), C(weighted(joined[4], b))};
    }
  }
  lines_.push_back(std::move(joined));
  return static_cast<LineId>(lines_.size() - 1);
}

template <class C>
bool ExactLines<C>::can_join(EndId a, EndId b) const {
  if constexpr (std::is_same_v<C, Words>) {
    const LineId s = line_of(a), o = line_of(b);
    const auto bits = [](const C& v, const C& w, const C& weight) {
      return std::max(v.bits(), w.bits()) + weight.bits();
    };
    return have_one_weight(s, o) ||
           std::max({bits(x(a), y(a), lines_[o][4]), bits(x(b), y(b), lines_[s][4]),
                     bits(lines_[s][4], {}, lines_[o][4])}) <= Arithmetic<C>::kBits;
  }
  return true;
}

template <class C>
void ExactLines<C>::reorder(const std::vector<LineId>& order, Job& job) {
  std::vector<Line> lines(order.size());
  job.for_each(order.size(), [&](std::size_t i) { lines[i] = std::move(lines_[order[i]]); });
  lines_ = std::move(lines);
}

// The supporting line is y = slope x + height with slope = dy / dx and height = (ay - slope ax) /
// weight; all divisions of a block are made with one inversion (Montgomery 1987).
template <class C>
void ExactLines<C>::keys(std::size_t begin, std::size_t end, std::uint64_t* key) const {
  struct Divisors {
    std::uint64_t dx, weight;
    std::uint64_t product() const {
      return field::multiply(std::max(dx, 1UL), std::max(weight, 1UL));
    }
  };
  const auto divisors = [&](LineId s) {
    Divisors d{residue(dx(s)), 1};
    if constexpr (kWeighted) d.weight = residue(lines_[s][4]);
    return d;
  };
  std::uint64_t all = 1;
  for (std::size_t s = begin; s < end; ++s) {
    key[s - begin] = all;
    all = field::multiply(all, divisors(static_cast<LineId>(s)).product());
  }
  std::uint64_t inverse = field::inverse(all);
  for (std::size_t i = end; i-- > begin;) {
    const auto s = static_cast<LineId>(i);
    std::uint64_t& k = key[i - begin];
    const Divisors d = divisors(s);
    const std::uint64_t inverse_of_product = field::multiply(inverse, k);
    inverse = field::multiply(inverse, d.product());
    const auto place = [&](const C& v) {
      const std::uint64_t r = residue(Difference(v));
      return kWeighted
                 ? field::multiply(r, field::multiply(inverse_of_product, std::max(d.dx, 1UL)))
                 : r;
    };
    const std::uint64_t ax = place(lines_[s][0]), ay = place(lines_[s][1]);
    if (d.weight == 0 || (d.dx == 0 && sign(dx(s)) != 0)) {
      k = key_of_rationals(s);
    } else if (d.dx != 0) {
      const std::uint64_t slope =
          field::multiply(residue(dy(s)), field::multiply(inverse_of_product, d.weight));
      k = field::key(slope, field::subtract(ay, field::multiply(slope, ax)));
    } else {
      k = is_point(s) ? field::key(field::kPoint, field::key(ax, ay))
                      : field::key(field::kVertical, ax);
    }
  }
}

/// The same key, or that of numbers without residue, where a multiple of the prime is in the way.
template <class C>
std::uint64_t ExactLines<C>::key_of_rationals(LineId s) const {
  mpz_class weight = 1;
  if constexpr (kWeighted) weight = to_mpz(lines_[s][4]);
  const Rational ax = quotient_of(to_mpz(Difference(lines_[s][0])), weight);
  const Rational ay = quotient_of(to_mpz(Difference(lines_[s][1])), weight);
  if (is_point(s)) return field::key(field::kPoint, field::key(residue(ax), residue(ay)));
  if (sign(dx(s)) == 0) return field::key(field::kVertical, residue(ax));
  const Rational slope = quotient_of(to_mpz(dy(s)), to_mpz(dx(s)));
  return field::key(residue(slope), residue(Rational(ay - slope * ax)));
}

template <class C>
auto ExactLines<C>::fraction(LineId s, LineId o) const -> std::pair<Product, Product> {
  const Product from = cross(o, first_end(s)), to = cross(o, last_end(s));
  return from > to ? std::pair<Product, Product>(from, from - to)
                   : std::pair<Product, Product>(-from, to - from);
}

template <class C>
double ExactLines<C>::parameter(LineId s, LineId o) const {
  const auto [n, d] = fraction(s, o);
  return quotient(n, d);
}

template <class C>
int ExactLines<C>::compare_along(LineId s, LineId o, LineId q) const {
  const auto [n, d] = fraction(s, o);
  const auto [m, e] = fraction(s, q);
  return compare_products(n, e, m, d);
}

// The orientation of c's ends and a point of s is linear along s, so at the crossing it has the
// sign of (1 - n/d) A + n/d B with its values A, B at the ends of s.
template <class C>
int ExactLines<C>::side_of_crossing(LineId c, LineId s, LineId o) const {
  const auto [n, d] = fraction(s, o);
  return compare_products(cross(c, first_end(s)), Product(d - n), Product(-cross(c, last_end(s))),
                          n);
}

template <class C>
int ExactLines<C>::compare_x(LineId s, LineId o, EndId end) const {
  const auto [n, d] = fraction(s, o);
  return compare_products(n, weighted_product(dx(s), line_of(end)), d, Product(from_x(s, end)));
}

// Height of s at the end's x: (ay + dy (x - ax) / dx) / weight = h / (weight dx), where h = dx ay +
// dy (x - ax), times the weight of the end, which both heights have.
template <class C>
int ExactLines<C>::compare_heights(LineId s, LineId o, EndId end) const {
  const auto height = [&](LineId line) {
    return Product(product(dx(line), weighted(lines_[line][1], end)) +
                   product(dy(line), from_x(line, end)));
  };
  const int by_height = compare_products(height(s), weighted_product(dx(o), o), height(o),
                                         weighted_product(dx(s), s));
  return by_height != 0 ? by_height : -compare_directions(s, o);
}

template <class C>
LongPoint ExactLines<C>::point(EndId end) const {
  mpz_class w = frame_.scale;
  if constexpr (kWeighted) w *= to_mpz(lines_[line_of(end)][4]);
  return {to_mpz(Difference(x(end))) + frame_.x, to_mpz(Difference(y(end))) + frame_.y,
          std::move(w)};
}

// With the frame's point c: (a + c) + n / d (b - a), over the scale or the weight.
template <class C>
LongPoint ExactLines<C>::crossing(LineId s, LineId o) const {
  using Factor = typename Arithmetic<C>::Factor;
  const auto [n, d] = fraction(s, o);
  const Factor numerator = factor<Factor>(n), denominator = factor<Factor>(d);
  Factor scale = factor<Factor>(frame_.scale);
  if constexpr (kWeighted) scale = Factor(lines_[s][4]);
  const auto at = [&](const C& from, const Difference& difference, const mpz_class& middle) {
    return to_mpz(product(factor<Factor>(from) + factor<Factor>(middle), denominator) +
                  product(factor<Factor>(difference), numerator));
  };
  return {at(lines_[s][0], dx(s), frame_.x), at(lines_[s][1], dy(s), frame_.y),
          to_mpz(product(scale, denominator))};
}

template class ExactLines<std::int32_t>;
template class ExactLines<Int128>;
template class ExactLines<Words>;
template class ExactLines<mpz_class>;

}  // namespace plumbline::bucket

#include "plumbline/geometry/point_list.hpp"

#include <cmath>
#include <optional>

#include "number/wide.hpp"

namespace plumbline {
namespace {

using wide::Int128;

/// Sign of x1 / w1 - x2 / w2.
int compare_quotients(Int128 x1, Int128 w1, Int128 x2, Int128 w2) {
  if (w1 == w2) return (x1 > x2) - (x1 < x2);
  return wide::compare_products(x1, w2, x2, w1);
}

/// The integer, where it is within the bounds of a WidePoint.
std::optional<Int128> integer(mpz_srcptr z) {
  if (mpz_sizeinbase(z, 2) > WidePoint::kBits) return {};
  constexpr mp_bitcnt_t kLimbBits = 64;
  static_assert(GMP_NUMB_BITS == kLimbBits);
  const Int128 size = static_cast<Int128>(
      (static_cast<wide::UInt128>(mpz_getlimbn(z, 1)) << kLimbBits) | mpz_getlimbn(z, 0));
  return mpz_sgn(z) < 0 ? -size : size;
}

/// a b, where it is within the bounds of a WidePoint.
std::optional<Int128> product(Int128 a, Int128 b) {
  Int128 result = 0;
  if (__builtin_mul_overflow(a, b, &result)) return {};
  if ((wide::magnitude(result) >> WidePoint::kBits) != 0) return {};
  return result;
}

std::optional<WidePoint> wide_point(const Point& p) {
  const auto x = integer(p.x.get_num_mpz_t()), y = integer(p.y.get_num_mpz_t());
  const auto d = integer(p.x.get_den_mpz_t()), e = integer(p.y.get_den_mpz_t());
  if (!x || !y || !d || !e) return {};
  if (*d == *e) return WidePoint{*x, *y, *d};
  const auto common = static_cast<Int128>(wide::gcd(wide::magnitude(*d), wide::magnitude(*e)));
  const auto wx = product(*x, *e / common), wy = product(*y, *d / common);
  const auto w = product(*d, *e / common);
  if (!wx || !wy || !w) return {};
  return WidePoint{*wx, *wy, *w};
}

}  // namespace

PointList::PointList(std::span<const Point> points) {
  reserve(points.size());
  for (const Point& p : points) push_back(p);
}

const Point PointList::operator[](std::size_t i) const {
  if (!is_wide(i)) return other(i);
  const auto& [x, y, w] = wide_[i];
  return {wide::quotient(x, w), wide::quotient(y, w)};
}

Point PointList::at(std::size_t i) const {
  static_cast<void>(wide_.at(i));
  return (*this)[i];
}

PointD PointList::nearest(std::size_t i) const {
  if (!is_wide(i)) return plumbline::nearest(other(i));
  const auto& [x, y, w] = wide_[i];
  return {wide::nearest_quotient(x, w), wide::nearest_quotient(y, w)};
}

PointD PointList::truncated(std::size_t i) const {
  if (!is_wide(i)) return {other(i).x.get_d(), other(i).y.get_d()};
  const auto& [x, y, w] = wide_[i];
  return {wide::truncated_quotient(x, w), wide::truncated_quotient(y, w)};
}

int PointList::compare(const PointList& a, std::size_t i, const PointList& b, std::size_t j) {
  if (a.is_wide(i) && b.is_wide(j)) {
    const WidePoint &p = a.wide_[i], &q = b.wide_[j];
    const int by_x = compare_quotients(p.x, p.w, q.x, q.w);
    return by_x != 0 ? by_x : compare_quotients(p.y, p.w, q.y, q.w);
  }
  const Point p = a[i], q = b[j];
  return p < q ? -1 : (q < p ? 1 : 0);
}

int PointList::compare_y(std::size_t i, std::size_t j) const {
  if (is_wide(i) && is_wide(j)) {
    return compare_quotients(wide_[i].y, wide_[i].w, wide_[j].y, wide_[j].w);
  }
  const int order = cmp((*this)[i].y, (*this)[j].y);
  return (order > 0) - (order < 0);
}

std::size_t PointList::count_before(const Point& p) const {
  std::size_t begin = 0, end = size();
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    if ((*this)[middle] < p) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  return begin;
}

void PointList::push_back(const Point& point) {
  wide_.push_back({0, 0, 0});
  if (const auto held = wide_point(point)) {
    wide_.back() = *held;
  } else {
    wide_.back().x = static_cast<Int128>(others_.size());
    others_.push_back(point);
  }
}

void PointList::push_back(const PointList& other, std::size_t i) {
  if (other.is_wide(i)) {
    wide_.push_back(other.wide_[i]);
  } else {
    push_back(other[i]);
  }
}

void PointList::replace(std::size_t i, const Point& point) {
  if (const auto held = wide_point(point)) {
    wide_[i] = *held;
  } else if (is_wide(i)) {
    wide_[i] = {static_cast<Int128>(others_.size()), 0, 0};
    others_.push_back(point);
  } else {
    others_[static_cast<std::size_t>(wide_[i].x)] = point;
  }
}

bool operator==(const PointList& a, const PointList& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (PointList::compare(a, i, b, i) != 0) return false;
  }
  return true;
}

}  // namespace plumbline

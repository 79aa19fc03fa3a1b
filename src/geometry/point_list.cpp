#include "plumbline/geometry/point_list.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "geometry/stored.hpp"
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

std::optional<WidePoint> wide_point(const LongPoint& p) {
  const auto x = integer(p.x.get_mpz_t()), y = integer(p.y.get_mpz_t());
  const auto w = integer(p.w.get_mpz_t());
  if (!x || !y || !w) return {};
  return WidePoint{*x, *y, *w};
}

/// With the least common denominator.
LongPoint long_point(const Point& p) {
  const mpz_class &d = p.x.get_den(), &e = p.y.get_den();
  if (d == e) return {p.x.get_num(), p.y.get_num(), d};
  const mpz_class w = lcm(d, e);
  return {p.x.get_num() * (w / d), p.y.get_num() * (w / e), w};
}
LongPoint long_point(const PointList& points, std::size_t i) {
  const WidePoint* p = points.wide(i);
  if (p == nullptr) return points.long_point(i);
  return {wide::integer(p->x), wide::integer(p->y), wide::integer(p->w)};
}

int compare_quotients(const mpz_class& x1, const mpz_class& w1, const mpz_class& x2,
                      const mpz_class& w2) {
  const int order = cmp(x1 * w2, x2 * w1);
  return (order > 0) - (order < 0);
}

/// Lexicographic order.
template <class Stored>
int compare_points(const Stored& p, const Stored& q) {
  const int by_x = compare_quotients(p.x, p.w, q.x, q.w);
  return by_x != 0 ? by_x : compare_quotients(p.y, p.w, q.y, q.w);
}

}  // namespace

Point lowest(const LongPoint& point) {
  return {wide::quotient(point.x, point.w), wide::quotient(point.y, point.w)};
}

PointList::PointList(std::span<const Point> points) {
  reserve(points.size());
  for (const Point& p : points) push_back(p);
}

PointList::PointList(std::vector<LongPoint> points) {
  reserve(points.size());
  for (LongPoint& p : points) push_back(std::move(p));
}

const Point PointList::operator[](std::size_t i) const {
  if (const WidePoint* p = wide(i)) return {wide::quotient(p->x, p->w), wide::quotient(p->y, p->w)};
  return lowest(long_point(i));
}

Point PointList::at(std::size_t i) const {
  static_cast<void>(wide_.at(i));
  return (*this)[i];
}

PointD PointList::nearest(std::size_t i) const {
  const auto at = [](const auto& p) {
    return PointD{wide::nearest_quotient(p.x, p.w), wide::nearest_quotient(p.y, p.w)};
  };
  return is_wide(i) ? at(wide_[i]) : at(long_point(i));
}

PointD PointList::truncated(std::size_t i) const {
  const auto at = [](const auto& p) {
    return PointD{wide::truncated_quotient(p.x, p.w), wide::truncated_quotient(p.y, p.w)};
  };
  return is_wide(i) ? at(wide_[i]) : at(long_point(i));
}

int PointList::compare(const PointList& a, std::size_t i, const PointList& b, std::size_t j) {
  if (a.is_wide(i) && b.is_wide(j)) return compare_points(a.wide_[i], b.wide_[j]);
  return compare_points(plumbline::long_point(a, i), plumbline::long_point(b, j));
}

int PointList::compare_y(std::size_t i, std::size_t j) const {
  if (is_wide(i) && is_wide(j)) {
    return compare_quotients(wide_[i].y, wide_[i].w, wide_[j].y, wide_[j].w);
  }
  const LongPoint p = plumbline::long_point(*this, i), q = plumbline::long_point(*this, j);
  return compare_quotients(p.y, p.w, q.y, q.w);
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

void PointList::push_back(LongPoint point) {
  if (const auto held = wide_point(point)) {
    wide_.push_back(*held);
  } else {
    wide_.push_back({static_cast<Int128>(long_.size()), 0, 0});
    long_.push_back(std::move(point));
  }
}

void PointList::push_back(const Point& point) { push_back(plumbline::long_point(point)); }

void PointList::push_back(const PointList& other, std::size_t i) {
  if (other.is_wide(i)) {
    wide_.push_back(other.wide_[i]);
  } else {
    push_back(other.long_point(i));
  }
}

void PointList::replace(std::size_t i, const Point& point) {
  LongPoint other = plumbline::long_point(point);
  if (const auto held = wide_point(other)) {
    wide_[i] = *held;
  } else if (is_wide(i)) {
    wide_[i] = {static_cast<Int128>(long_.size()), 0, 0};
    long_.push_back(std::move(other));
  } else {
    long_[static_cast<std::size_t>(wide_[i].x)] = std::move(other);
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

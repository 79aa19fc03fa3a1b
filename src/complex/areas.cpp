// A sum of fractions is taken half by half and brought to lowest terms once: so numbers stay as
// short as they can, and few greatest common divisors are needed.

#include <optional>
#include <span>
#include <utility>

#include "number/wide.hpp"
#include "plumbline/complex.hpp"

namespace plumbline {
namespace {

/// n / d, not in lowest terms.
struct Fraction {
  mpz_class n, d;
};

LongPoint place(const PointList& points, std::size_t i) {
  if (const WidePoint* p = points.wide(i)) {
    return {wide::integer(p->x), wide::integer(p->y), wide::integer(p->w)};
  }
  return points.long_point(i);
}

/// Twice the signed area to the left of the chain of points, from the origin.
Fraction twice_area(std::span<const LongPoint> chain) {
  if (chain.size() == 2) {
    const LongPoint &p = chain[0], &q = chain[1];
    return {p.x * q.y - q.x * p.y, p.w * q.w};
  }
  const std::size_t middle = chain.size() / 2;
  const Fraction a = twice_area(chain.first(middle + 1)), b = twice_area(chain.subspan(middle));
  return {a.n * b.d + b.n * a.d, a.d * b.d};
}

/// A point of integers of 50 bits.
struct GridPoint {
  wide::Int128 x, y;
};

std::optional<GridPoint> grid_point(const WidePoint* p) {
  constexpr wide::Int128 kMost = wide::Int128{1} << 50;
  if (p == nullptr) return {};
  GridPoint result{p->x, p->y};
  if (p->w != 1) {
    if (p->x % p->w != 0 || p->y % p->w != 0) return {};
    result = {p->x / p->w, p->y / p->w};
  }
  const auto is_small = [](wide::Int128 v) { return v <= kMost && v >= -kMost; };
  if (!is_small(result.x) || !is_small(result.y)) return {};
  return result;
}

/// The signed area of a cycle of such points, whose sums 127 bits hold.
std::optional<Rational> grid_area(const ExactComplex& complex, std::span<const HalfedgeId> cycle) {
  constexpr std::size_t kMostPoints = 1U << 20;
  if (cycle.size() > kMostPoints) return {};
  auto p = grid_point(complex.vertices.wide(complex.origin(cycle.back())));
  wide::Int128 twice = 0;
  for (const HalfedgeId h : cycle) {
    const auto q = grid_point(complex.vertices.wide(complex.origin(h)));
    if (!p || !q) return {};
    twice += p->x * q->y - q->x * p->y;
    p = q;
  }
  return wide::quotient(twice, 2);
}

Rational area(const ExactComplex& complex, CycleId cycle) {
  if (auto area = grid_area(complex, complex.cycles[cycle])) return *std::move(area);
  std::vector<LongPoint> chain;
  chain.reserve(complex.cycles[cycle].size() + 1);
  for (const HalfedgeId h : complex.cycles[cycle]) {
    chain.push_back(place(complex.vertices, complex.origin(h)));
  }
  chain.push_back(chain.front());
  const Fraction twice = twice_area(chain);
  Rational result(twice.n, 2 * twice.d);
  result.canonicalize();
  return result;
}

}  // namespace

std::vector<Rational> cycle_areas(const ExactComplex& complex) {
  std::vector<Rational> areas(complex.cycles.size());
  for (std::size_t c = 0; c < areas.size(); ++c) areas[c] = area(complex, CycleId(c));
  return areas;
}

Rational face_area(const ExactComplex& complex, FaceId f) {
  if (f == kUnbounded) return 0;
  Rational result = area(complex, complex.face_outer[f]);
  for (const CycleId hole : complex.face_holes[f]) result += area(complex, hole);
  return result;
}

std::vector<Rational> face_areas(const ExactComplex& complex) {
  std::vector<Rational> areas(complex.face_count());
  for (std::size_t f = 1; f < areas.size(); ++f) areas[f] = face_area(complex, FaceId(f));
  return areas;
}

}  // namespace plumbline

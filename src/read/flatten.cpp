#include "read/flatten.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "plumbline/error.hpp"
#include "read/attribute.hpp"

namespace plumbline {
namespace {

/// A control point (w x, w y, w) times a common denominator, on which de Casteljau needs integers
/// only.
struct Homogeneous {
  mpz_class x, y, w;
};

/// Tolerances that nobody gave are from the curve's longer side / kFinest to / kCoarsest.
constexpr int kFinest = 1000, kCoarsest = 10;

Rational squared_length(const Point& p) { return p.x * p.x + p.y * p.y; }

std::vector<Homogeneous> homogeneous(std::span<const Point> points,
                                     std::span<const Rational> weights) {
  std::vector<Point> weighted(points.begin(), points.end());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weighted[i].x *= weights[i];
    weighted[i].y *= weights[i];
  }
  mpz_class denominator = 1;
  const auto include = [&](const Rational& r) { denominator = lcm(denominator, r.get_den()); };
  for (const Point& p : weighted) {
    include(p.x);
    include(p.y);
  }
  for (const Rational& w : weights) include(w);
  const auto scaled = [&](const Rational& r) {
    return mpz_class(r.get_num() * (denominator / r.get_den()));
  };
  std::vector<Homogeneous> result;
  result.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.push_back({scaled(weighted[i].x), scaled(weighted[i].y),
                      weights.empty() ? denominator : scaled(weights[i])});
  }
  return result;
}

/// The point at i / 2^k, by de Casteljau; times (2^k)^degree throughout.
NumberPoint point_at(std::vector<Homogeneous> b, unsigned long i, unsigned long k) {
  const unsigned long rest = (1UL << k) - i;
  for (std::size_t count = b.size() - 1; count > 0; --count) {
    for (std::size_t j = 0; j < count; ++j) {
      b[j].x = rest * b[j].x + i * b[j + 1].x;
      b[j].y = rest * b[j].y + i * b[j + 1].y;
      b[j].w = rest * b[j].w + i * b[j + 1].w;
    }
  }
  Rational x(b[0].x, b[0].w);
  Rational y(b[0].y, b[0].w);
  x.canonicalize();
  y.canonicalize();
  return {std::move(x), std::move(y)};
}

/// A bound on the squared distance between the curve and one chord from end to end at equal
/// parameters. Over a parameter length h it is smaller by h^4.
///
/// Linear interpolation of a function f over [0, 1] is off by at most max |f''| / 8, and |f''| of a
/// Bezier curve of degree n is at most n (n - 1) times the largest second difference of its control
/// points. For weights w, with f = w (point - origin), an error e of f and d of w move the quotient
/// by at most (e + r d) / min w, r being the farthest control point's distance from the origin.
Rational squared_chord_error(std::span<const Point> points, std::span<const Rational> weights) {
  const auto degree = static_cast<long>(points.size()) - 1;
  const Rational factor(degree * (degree - 1), 8);
  std::vector<Point> f;
  Rational squared_radius;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p{points[i].x - points[0].x, points[i].y - points[0].y};
    squared_radius = std::max(squared_radius, squared_length(p));
    f.push_back(weights.empty() ? p : Point{p.x * weights[i], p.y * weights[i]});
  }
  Rational point_change;   // squared
  Rational weight_change;  // squared
  for (std::size_t i = 2; i < points.size(); ++i) {
    point_change = std::max(point_change, squared_length({f[i].x - 2 * f[i - 1].x + f[i - 2].x,
                                                          f[i].y - 2 * f[i - 1].y + f[i - 2].y}));
    if (weights.empty()) continue;
    const Rational change = weights[i] - 2 * weights[i - 1] + weights[i - 2];
    weight_change = std::max(weight_change, Rational(change * change));
  }
  Rational sum = point_change;
  if (weight_change != 0) sum = 2 * (point_change + squared_radius * weight_change);
  if (!weights.empty()) {
    const Rational least = *std::min_element(weights.begin(), weights.end());
    sum /= least * least;
  }
  return factor * factor * sum;
}

}  // namespace

Flattener::Flattener(const ReadOptions& options, Rational least_tolerance,
                     std::size_t max_document_chords)
    : tolerance_(options.chord_tolerance),
      least_tolerance_(std::move(least_tolerance)),
      chords_left_(std::min(max_document_chords, options.max_segments)) {
  if (sgn(tolerance_) < 0) {
    throw Error(ErrorCode::BadInput, "negative chord tolerance", {}, exact_text(tolerance_));
  }
}

void Flattener::spend(std::size_t chords) {
  if (chords > chords_left_) {
    throw Error(ErrorCode::Limit,
                "the curves of the drawing take too many chords; take a larger tolerance");
  }
  chords_left_ -= chords;
  has_curves_ = true;
}

Rational Flattener::squared_tolerance(std::span<const Point> points) const {
  if (sgn(tolerance_) > 0) return tolerance_ * tolerance_;
  const auto extent = [points](Rational Point::*coordinate) -> Rational {
    const auto less = [coordinate](const Point& p, const Point& q) {
      return p.*coordinate < q.*coordinate;
    };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    return *high.*coordinate - *low.*coordinate;
  };
  const Rational longer = std::max(extent(&Point::x), extent(&Point::y));
  const Rational tolerance =
      std::clamp(least_tolerance_, Rational(longer / kFinest), Rational(longer / kCoarsest));
  return tolerance * tolerance;
}

Chords Flattener::bezier(std::span<const Point> points, std::span<const Rational> weights) {
  constexpr unsigned long kLoop = 2;  // halvings, so that what comes back has some extent
  const Rational tolerance = squared_tolerance(points);
  Rational error = squared_chord_error(points, weights);
  unsigned long k = 0;
  while (error > tolerance || (k < kLoop && sgn(error) != 0 && points.front() == points.back())) {
    error /= 16;
    if ((std::size_t{1} << ++k) > kMaxChords) {
      throw Unusable{"curve of more than " + std::to_string(kMaxChords) + " chords", {}};
    }
  }
  const unsigned long count = 1UL << k;
  spend(count);
  Chords chords;
  chords.bound = nearest_sqrt(error);
  chords.points.reserve(count + 1);
  chords.points.push_back({points.front().x, points.front().y});
  const std::vector<Homogeneous> control = homogeneous(points, weights);
  for (unsigned long i = 1; i < count; ++i) chords.points.push_back(point_at(control, i, k));
  chords.points.push_back({points.back().x, points.back().y});
  return chords;
}

}  // namespace plumbline

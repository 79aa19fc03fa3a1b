// SPLINE: the Bezier pieces of a B-spline with weights, by its polar form. Exact.

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "geometry/text_rounding.hpp"
#include "read/dxf/curves.hpp"

namespace plumbline::dxf {
namespace {

/// A point times its weight, and the weight.
struct WeightedPoint {
  Rational x, y, w;
};

struct Spline {
  std::size_t degree = 0;
  std::vector<Rational> knots;
  std::vector<WeightedPoint> points;
};

constexpr int kDegree = 71;
constexpr int kKnot = 40;
constexpr int kWeight = 41;
constexpr int kControlX = 10;
constexpr int kControlY = 20;
constexpr int kFitX = 11;

/// That of AutoCAD.
constexpr std::int64_t kMaxDegree = 11;
/// Largest number of a piece, in words: a degree multiplies the length of the numbers in a file.
constexpr std::size_t kMaxPieceWords = std::size_t{1} << 12U;

std::vector<Rational> all_numbers(const Entity& entity, int code) {
  std::vector<Rational> values;
  for (const Group& group : entity.record().groups) {
    if (group.code == code) values.push_back(number_of(group, entity.numbers()).rational());
  }
  return values;
}

[[noreturn]] void refuse(const std::string& reason) { throw Unusable{reason, {}}; }

void check(const Spline& spline) {
  const std::size_t n = spline.points.size();
  if (n < spline.degree + 1) refuse("fewer control points than the degree of the spline needs");
  if (spline.knots.size() != n + spline.degree + 1) {
    refuse("a spline of degree " + std::to_string(spline.degree) + " with " + std::to_string(n) +
           " control points and " + std::to_string(spline.knots.size()) + " knots");
  }
  if (!std::is_sorted(spline.knots.begin(), spline.knots.end())) refuse("knots out of order");
  const auto is_positive = [](const WeightedPoint& p) { return sgn(p.w) > 0; };
  if (!std::all_of(spline.points.begin(), spline.points.end(), is_positive)) {
    refuse("a weight of the spline is not positive");
  }
}

Spline spline_of(const Entity& entity) {
  const std::int64_t degree = entity.integer(kDegree, 3);
  if (degree < 1 || degree > kMaxDegree) refuse("degree of the spline: " + std::to_string(degree));
  Spline spline{static_cast<std::size_t>(degree), all_numbers(entity, kKnot), {}};
  const auto x = all_numbers(entity, kControlX);
  const auto y = all_numbers(entity, kControlY);
  const auto weights = all_numbers(entity, kWeight);
  if (x.empty() && entity.has(kFitX)) refuse("spline by fit points only");
  if (x.size() != y.size()) refuse("control point without group 20");
  if (!weights.empty() && weights.size() != x.size()) refuse("not one weight per control point");
  spline.points.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Rational w = weights.empty() ? Rational(1) : weights[i];
    spline.points.push_back({w * x[i], w * y[i], w});
  }
  check(spline);
  return spline;
}

void check_size(const Rational& number) {
  if (mpz_size(number.get_num_mpz_t()) + mpz_size(number.get_den_mpz_t()) > kMaxPieceWords) {
    refuse("the numbers of the spline grow too long");
  }
}

/// The polar form of the piece between knots k and k + 1, at `low` of its arguments knot k and at
/// the others knot k + 1.
WeightedPoint polar_form(const Spline& spline, std::size_t k, std::size_t low) {
  const std::size_t p = spline.degree;
  const auto& u = spline.knots;
  const auto begin = spline.points.begin() + static_cast<std::ptrdiff_t>(k - p);
  std::vector<WeightedPoint> d(begin, begin + static_cast<std::ptrdiff_t>(p) + 1);
  for (std::size_t level = 1; level <= p; ++level) {
    const Rational& t = u[level <= low ? k : k + 1];
    for (std::size_t i = 0; i + level <= p; ++i) {
      // d[i] is the point of index k - p + level + i of this level, and its knots differ: the piece
      // is between them.
      const Rational& left = u[k - p + level + i];
      const Rational s = (t - left) / (u[k + 1 + i] - left);
      d[i].x += s * (d[i + 1].x - d[i].x);
      d[i].y += s * (d[i + 1].y - d[i].y);
      d[i].w += s * (d[i + 1].w - d[i].w);
      for (const Rational* number : {&d[i].x, &d[i].y, &d[i].w}) check_size(*number);
    }
  }
  return d[0];
}

double rounding_of_controls(const Entity& entity) {
  double rounding = 0;
  for (const Group& group : entity.record().groups) {
    if (group.code != kControlX && group.code != kControlY) continue;
    rounding = std::max(rounding, text_rounding(number_of(group, entity.numbers()), {}));
  }
  return rounding;
}

}  // namespace

DrawnEntity draw_spline(const Entity& entity, Pen& pen) {
  const Spline spline = spline_of(entity);
  const std::size_t p = spline.degree;
  DrawnEntity drawn;
  double bound = 0;
  std::vector<NumberPoint> all;
  for (std::size_t k = p; k < spline.points.size(); ++k) {
    if (spline.knots[k] == spline.knots[k + 1]) continue;
    std::vector<Point> points;
    std::vector<Rational> weights;
    for (std::size_t j = 0; j <= p; ++j) {
      const WeightedPoint b = polar_form(spline, k, p - j);
      points.push_back({b.x / b.w, b.y / b.w});
      weights.push_back(b.w);
    }
    Chords chords = pen.bezier(points, weights);
    if (all.empty()) all.push_back(std::move(chords.points.front()));
    std::move(chords.points.begin() + 1, chords.points.end(), std::back_inserter(all));
    bound = std::max(bound, chords.bound);
  }
  if (all.empty()) refuse("spline without extent: all its knots are equal");
  const double rounding = rounding_of_controls(entity);
  append_curve(drawn, all, {0, 0, std::nullopt, bound, {rounding, rounding}, 0});
  drawn.replaced.push_back(by_chords("spline", bound));
  return drawn;
}

}  // namespace plumbline::dxf

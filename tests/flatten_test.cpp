// Curves as chords between exact points of the curve.

#include "read/flatten.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "number/bound_text.hpp"
#include "plumbline/error.hpp"
#include "read/attribute.hpp"

using namespace plumbline;

namespace {

ReadOptions within(const Rational& tolerance) {
  ReadOptions options;
  options.chord_tolerance = tolerance;
  return options;
}

std::string text_of(const Chords& chords) {
  std::string text;
  for (const NumberPoint& p : chords.points) text += (text.empty() ? "" : ", ") + to_text(p);
  return text;
}

Point exact_point(const NumberPoint& p) { return {p.x.rational(), p.y.rational()}; }

Rational squared_norm(const Point& p) { return p.x * p.x + p.y * p.y; }

Ellipse circle(const Rational& radius) { return {{0, 0}, {radius, 0}, {0, radius}}; }

/// The largest distance of a point of the curve, taken at many parameters, from its own chord.
template <class Curve>
double largest_deviation(const Chords& chords, Curve curve) {
  const std::size_t count = chords.points.size() - 1;
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Point a = exact_point(chords.points[i]);
    const Point b = exact_point(chords.points[i + 1]);
    for (int j = 1; j < 8; ++j) {
      const Point p = curve((static_cast<double>(i) + j / 8.0) / static_cast<double>(count));
      largest = std::max(largest, nearest_sqrt(squared_distance(p, a, b)));
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("a quadratic curve is halved until its second difference, over 4 and again by 4, fits") {
  // The second difference of (0,0) (1,2) (2,0) is (0,-4): chords are off by 1 / 4^k at most.
  const std::vector<Point> points{{0, 0}, {1, 2}, {2, 0}};
  CHECK(text_of(Flattener(within(1)).bezier(points)) == "0 0, 2 0");
  CHECK(text_of(Flattener(within(Rational(99, 100))).bezier(points)) == "0 0, 1 1, 2 0");
  CHECK(text_of(Flattener(within(Rational(1, 4))).bezier(points)) == "0 0, 1 1, 2 0");
  CHECK(text_of(Flattener(within(Rational(1, 5))).bezier(points)) ==
        "0 0, 0.5 0.75, 1 1, 1.5 0.75, 2 0");
  CHECK(Flattener(within(Rational(1, 5))).bezier(points).bound == 1.0 / 16);
}

TEST_CASE("a cubic curve passes exactly through its points at dyadic parameters") {
  // B(1/2) = (p0 + 3 p1 + 3 p2 + p3) / 8; B(1/4) = (27 p0 + 27 p1 + 9 p2 + p3) / 64.
  const std::vector<Point> points{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  const Chords chords = Flattener(within(Rational(1, 10))).bezier(points);
  CHECK(text_of(chords) == "0 0, 0.15625 0.5625, 0.5 0.75, 0.84375 0.5625, 1 0");
}

TEST_CASE("a straight curve with evenly spaced control points is one chord, without any bound") {
  const Chords chords = Flattener({}).bezier(std::vector<Point>{{0, 0}, {1, 2}, {2, 4}, {3, 6}});
  CHECK(text_of(chords) == "0 0, 3 6");
  CHECK(chords.bound == 0);
}

TEST_CASE("a curve gives the same points from either end") {
  const std::vector<Point> points{{0, 0}, {7, 1}, {Rational(1, 3), 5}, {2, 9}};
  const std::vector<Point> reversed(points.rbegin(), points.rend());
  Chords back = Flattener({}).bezier(reversed);
  std::reverse(back.points.begin(), back.points.end());
  CHECK(Flattener({}).bezier(points).points == back.points);
}

TEST_CASE("a loop keeps some extent, however large the tolerance") {
  const std::vector<Point> loop{{0, 0}, {4, 4}, {-4, 4}, {0, 0}};
  CHECK(Flattener(within(1000)).bezier(loop).points.size() == 5);
}

TEST_CASE("a rational quadratic curve with weights 1, 1, 2 is a quarter of the circle, exactly") {
  // The standard parametrisation ((1 - t^2), 2 t) / (1 + t^2).
  const std::vector<Point> points{{1, 0}, {1, 1}, {0, 1}};
  const std::vector<Rational> weights{1, 1, 2};
  const Chords chords = Flattener(within(Rational(1, 100))).bezier(points, weights);
  CHECK(chords.points.size() >= 8);
  for (const NumberPoint& p : chords.points) CHECK(squared_norm(exact_point(p)) == 1);
  CHECK(largest_deviation(chords, [](double t) {
          return exact(PointD{(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)});
        }) <= chords.bound);
  CHECK(chords.bound <= 0.01);
}

TEST_CASE("no chord is farther from its curve than stated, whatever the control points") {
  std::uint64_t seed = 5;
  const auto next = [&seed] {
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(seed >> 40U) / 65536;
  };
  for (int i = 0; i < 50; ++i) {
    std::vector<PointD> p(4);
    std::vector<Point> points;
    for (PointD& q : p) points.push_back(exact(q = {next(), next()}));
    const auto curve = [&p](double t) {
      const double s = 1 - t;
      const double b[] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
      PointD sum;
      for (int j = 0; j < 4; ++j) {
        sum.x += b[j] * p[j].x;
        sum.y += b[j] * p[j].y;
      }
      return exact(sum);
    };
    const Chords chords = Flattener(within(Rational(1, 10))).bezier(points);
    CHECK(chords.bound <= 0.1);
    CHECK(largest_deviation(chords, curve) <= chords.bound * (1 + 1e-9));
  }
}

TEST_CASE("a tolerance that would take too many chords is refused") {
  const std::vector<Point> points{{0, 0}, {1, 2}, {2, 0}};
  CHECK_THROWS_AS(Flattener(within(Rational("1/1000000000000"))).bezier(points), Unusable);
  CHECK_THROWS_AS(Flattener(within(Rational("1/1000000000000"))).ellipse(circle(1)), Unusable);
  CHECK_NOTHROW(Flattener(within(Rational("1/100000000"))).ellipse(circle(1)));
  CHECK_THROWS_AS(Flattener(within(-1)), Error);
}

TEST_CASE("a drawing whose curves take too many chords in all is refused") {
  Flattener flattener(within(Rational(1, 1000)), 0, 100);
  const std::size_t chords = flattener.ellipse(circle(1)).points.size() - 1;
  CHECK(chords > 50);
  CHECK_THROWS_AS(flattener.ellipse(circle(1)), Error);
}

TEST_CASE(
    "a circle is a polygon of exact points of the circle, its quarters images of each other") {
  for (const Rational& tolerance :
       {Rational(1), Rational(1, 10), Rational(1, 100), Rational(1, 1000), Rational(1, 100'000)}) {
    const Chords chords = Flattener(within(tolerance)).ellipse(circle(10));
    const std::size_t n = chords.points.size() - 1;
    CAPTURE(tolerance, n);
    REQUIRE(n % 4 == 0);
    CHECK(chords.points.front() == chords.points.back());
    CHECK(to_text(chords.points[0]) == "10 0");
    double longest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Point p = exact_point(chords.points[i]);
      CHECK(squared_norm(p) == 100);
      const Point q = exact_point(chords.points[(i + n / 4) % n]);
      CHECK(q == Point{-p.y, p.x});
      CHECK(exact_point(chords.points[(n - i) % n]) == Point{p.x, -p.y});
      longest =
          std::max(longest, nearest_sqrt(squared_distance(p, exact_point(chords.points[i + 1]))));
    }
    CHECK(10 - std::sqrt(100 - longest * longest / 4) <= nearest_double(tolerance));
    // Even chords would be n: the exact ones are not even, but not twice as many.
    CHECK(static_cast<double>(n) <
          2 * std::ceil(3.1415927 / std::acos(1 - nearest_double(tolerance) / 10)));
  }
}

TEST_CASE("the points of a circle share a small denominator") {
  mpz_class common = 1;
  for (const NumberPoint& p : Flattener({}).ellipse(circle(1)).points) {
    common = lcm(lcm(common, p.x.rational().get_den()), p.y.rational().get_den());
  }
  CHECK(common == 5 * 5 * 13 * 17);
}

TEST_CASE("an ellipse is flattened as far as its longer axis needs") {
  const Ellipse slanted{{1, 2}, {3, 4}, {Rational(-2, 5), Rational(3, 10)}};
  const Chords chords = Flattener(within(Rational(1, 100))).ellipse(slanted);
  CHECK(chords.points.size() > 4 * 8);
  for (const NumberPoint& point : chords.points) {
    const Point p{point.x.rational() - 1, point.y.rational() - 2};
    const Rational x = (3 * p.x + 4 * p.y) / 25;
    const Rational y = (-4 * p.x + 3 * p.y) * 2 / 5;
    CHECK(x * x + y * y == 1);
  }
}

TEST_CASE("an arc by bulge has its ends and all its points exactly on one circle") {
  // bulge = tan(angle / 4): 1 is half a circle, 1/2 turns by 4 atan(1/2), from the DXF reference.
  const auto check = [](const Point& a, const Point& b, const Rational& bulge) {
    const EllipticArc arc = bulge_arc(a, b, bulge);
    const Chords chords = Flattener({}).arc(arc);
    CHECK(exact_point(chords.points.front()) == a);
    CHECK(exact_point(chords.points.back()) == b);
    const Rational squared_radius = squared_distance(arc.ellipse.centre, a);
    for (std::size_t i = 0; i < chords.points.size(); ++i) {
      const Point p = exact_point(chords.points[i]);
      CHECK(squared_distance(p, arc.ellipse.centre) == squared_radius);
      if (i == 0) continue;
      const int turn = orientation(arc.ellipse.centre, exact_point(chords.points[i - 1]), p);
      CHECK(turn == sgn(bulge));
    }
    return chords.points.size();
  };
  CHECK(bulge_arc({0, 0}, {2, 0}, 1).ellipse.centre == Point{1, 0});
  CHECK(bulge_arc({0, 0}, {2, 0}, Rational(1, 2)).ellipse.centre == Point{1, Rational(3, 4)});
  CHECK(bulge_arc({0, 0}, {2, 0}, Rational(-1, 2)).ellipse.centre == Point{1, Rational(-3, 4)});
  CHECK(bulge_arc({0, 0}, {2, 0}, 2).ellipse.centre == Point{1, Rational(-3, 4)});
  const std::size_t half = check({0, 0}, {2, 0}, 1);
  CHECK(check({0, 0}, {2, 0}, Rational(1, 10)) < half);
  CHECK(check({0, 0}, {2, 0}, -3) > half);
  CHECK(check({Rational(1, 10), 5}, {-3, Rational(77, 10)}, Rational(-123, 1000)) > 2);
}

TEST_CASE(
    "an arc by angles starts and ends at rational points of the circle, exact at right angles") {
  CHECK(circle_point(90).point == Point{0, 1});
  CHECK(circle_point(-180).bound == 0);
  const ApproximatePoint sixty = circle_point(60, 1e-9);
  CHECK(squared_norm(sixty.point) == 1);
  CHECK(nearest_double(sixty.point.x) == Approx(0.5).margin(1e-9));
  CHECK(sixty.bound == rational_from(1e-9));
  EllipticArc arc{circle(2), circle_point(60).point, circle_point(300).point, false};
  const Chords through_180 = Flattener({}).arc(arc);
  arc.clockwise = true;
  const Chords through_0 = Flattener({}).arc(arc);
  for (const NumberPoint& p : through_180.points) CHECK(nearest(p).x < 1 + 1e-12);
  for (const NumberPoint& p : through_0.points) CHECK(nearest(p).x > 1 - 1e-12);
  CHECK(through_0.points.front() == through_180.points.front());
  CHECK(through_0.points.back() == through_180.points.back());
}

TEST_CASE("an arc gives the same points from either end") {
  for (const int degrees : {1, 17, 90, 135, 200, 359}) {
    EllipticArc arc{circle(3), circle_point(30).point, circle_point(30 + degrees).point, false};
    const Chords forward = Flattener({}).arc(arc);
    std::swap(arc.start, arc.end);
    arc.clockwise = true;
    Chords back = Flattener({}).arc(arc);
    std::reverse(back.points.begin(), back.points.end());
    CHECK(forward.points == back.points);
  }
}

TEST_CASE("arcs that share a start and an end make up the whole circle") {
  double turned = 0;
  EllipticArc arc{circle(1), circle_point(20).point, circle_point(20).point, false};
  const Chords whole = Flattener({}).arc(arc);
  for (std::size_t i = 1; i < whole.points.size(); ++i) {
    const PointD p = nearest(whole.points[i - 1]);
    const PointD q = nearest(whole.points[i]);
    const double angle = std::asin(p.x * q.y - p.y * q.x);
    CHECK(angle > 0);
    CHECK(1 - std::cos(angle / 2) <= 0.002);
    turned += angle;
  }
  CHECK(turned == Approx(2 * 3.14159265358979));
}

TEST_CASE("a bound is written with two digits, rounded up") {
  CHECK(bound_text(0.00123) == "0.0013");
  CHECK(bound_text(0.25) == "0.25");
  CHECK(bound_text(0.0999) == "0.1");
  CHECK(bound_text(1.21e-9) == "1.3e-09");
  CHECK(bound_text(0) == "0");
}

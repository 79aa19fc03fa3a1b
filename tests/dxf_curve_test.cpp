#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "plumbline/read.hpp"
#include "support/dxf_text.hpp"
#include "support/listing.hpp"

using plumbline::dxf_with;
using plumbline::evaluate;
using plumbline::Point;
using plumbline::Rational;
using plumbline::read_dxf;
using plumbline::Segment;
using plumbline::SegmentSet;

namespace {

SegmentSet drawn(const std::string& entities, const Rational& tolerance = 0) {
  plumbline::ReadOptions options;
  options.chord_tolerance = tolerance;
  return evaluate(read_dxf(dxf_with(entities), "a.dxf", options));
}

/// Whether each segment starts exactly where the one before it ends.
bool is_chain(const SegmentSet& set) {
  for (std::size_t i = 1; i < set.segments.size(); ++i) {
    if (set.segments[i - 1].b != set.segments[i].a) return false;
  }
  return !set.segments.empty();
}

Point first(const SegmentSet& set) { return set.segments[0].a; }
Point last(const SegmentSet& set) { return set.segments[set.segments.size() - 1].b; }

/// Whether both ends of all segments are exactly on the circle.
bool is_on_circle(const SegmentSet& set, const Point& centre, const Rational& radius) {
  return std::all_of(set.segments.begin(), set.segments.end(), [&](const Segment& s) {
    return squared_distance(s.a, centre) == radius * radius &&
           squared_distance(s.b, centre) == radius * radius;
  });
}

double length(const SegmentSet& set) {
  double sum = 0;
  for (const Segment& s : set.segments) {
    sum += std::sqrt(plumbline::nearest_double(squared_distance(s.a, s.b)));
  }
  return sum;
}

std::string ledger_of(const SegmentSet& set) {
  std::string text;
  for (const auto& entry : set.ledger) text += entry.what + ", ";
  return text;
}

std::string rejected(const std::string& entities) { return rejected_of(drawn(entities)); }

const double kPi = std::acos(-1.0);

}  // namespace

TEST_CASE("a CIRCLE is a closed chain of exact points of the circle") {
  const SegmentSet set = drawn("0 CIRCLE 8 0 10 0.3 20 -7 40 2.5");
  CHECK(is_chain(set));
  CHECK(first(set) == last(set));
  CHECK(is_on_circle(set, {Rational(3, 10), -7}, Rational(5, 2)));
  CHECK(length(set) == Approx(5 * kPi).epsilon(0.01));
  CHECK(length(set) < 5 * kPi);
  CHECK(ledger_of(set) == "circle by chords, ");
}

TEST_CASE("an ARC goes counter-clockwise from its first angle to its second") {
  const SegmentSet quarter = drawn("0 ARC 8 0 10 1 20 1 40 2 50 90 51 180");
  CHECK(is_chain(quarter));
  CHECK(first(quarter) == Point{1, 3});
  CHECK(last(quarter) == Point{-1, 1});
  CHECK(is_on_circle(quarter, {1, 1}, 2));
  CHECK(ledger_of(quarter) == "arc by chords, ");
  const SegmentSet rest = drawn("0 ARC 8 0 10 1 20 1 40 2 50 180 51 90");
  CHECK(first(rest) == Point{-1, 1});
  CHECK(last(rest) == Point{1, 3});
  CHECK(length(rest) == Approx(3 * kPi).epsilon(0.01));
  const SegmentSet across = drawn("0 ARC 8 0 10 1 20 1 40 2 50 270 51 450");
  CHECK(first(across) == Point{1, -1});
  CHECK(last(across) == Point{1, 3});
  CHECK(length(across) == Approx(2 * kPi).epsilon(0.01));
}

TEST_CASE("an ARC between oblique angles ends on the circle, within the bound on angles") {
  const SegmentSet set = drawn("0 ARC 8 0 10 0 20 0 40 5 50 30 51 77.123");
  CHECK(is_on_circle(set, {0, 0}, 5));
  CHECK(plumbline::nearest_double(first(set).y) == Approx(2.5).margin(1e-14));
  CHECK(plumbline::nearest_double(last(set).y) ==
        Approx(5 * std::sin(77.123 * kPi / 180)).margin(1e-14));
  CHECK(ledger_of(set) == "arc by chords, end of an arc, ");
}

TEST_CASE("an ARC of a whole turn is closed; one without angle or radius is refused") {
  const SegmentSet whole = drawn("0 ARC 8 0 10 0 20 0 40 1 50 0 51 360");
  CHECK(first(whole) == last(whole));
  CHECK(length(whole) == Approx(2 * kPi).epsilon(0.01));
  CHECK(rejected("0 ARC 8 0 10 0 20 0 40 1 50 30 51 30.0") ==
        "a.dxf:6 ARC (0): arc of no angle: group 51: 30.0\n");
  CHECK(rejected("0 ARC 8 0 10 0 20 0 40 -1 50 30 51 60") ==
        "a.dxf:6 ARC (0): radius is not positive: group 40: -1\n");
  CHECK(rejected("0 CIRCLE 8 0 10 0 20 0 40 0") ==
        "a.dxf:6 CIRCLE (0): radius is not positive: group 40: 0\n");
}

TEST_CASE("towards -z, an ARC is mirrored in x") {
  const SegmentSet set = drawn("0 ARC 8 0 10 10 20 0 40 1 50 0 51 90 210 0 220 0 230 -1");
  CHECK(first(set) == Point{-11, 0});
  CHECK(last(set) == Point{-10, 1});
  CHECK(is_on_circle(set, {-10, 0}, 1));
}

TEST_CASE("a bulge is an exact arc; 1 is a half circle, positive turns counter-clockwise") {
  const SegmentSet half = drawn("0 LWPOLYLINE 8 0 10 0 20 0 42 1 10 2 20 0");
  CHECK(is_chain(half));
  CHECK(is_on_circle(half, {1, 0}, 1));
  CHECK(first(half) == Point{0, 0});
  CHECK(last(half) == Point{2, 0});
  CHECK(std::all_of(half.segments.begin(), half.segments.end(),
                    [](const Segment& s) { return sgn(s.a.y) <= 0; }));
  CHECK(length(half) == Approx(kPi).epsilon(0.01));
  // tan(angle / 4) = -1/2: sine of half the angle is 4/5, so the radius is 5/4.
  const SegmentSet left = drawn("0 LWPOLYLINE 8 0 10 0 20 0 42 -0.5 10 2 20 0");
  CHECK(is_on_circle(left, {1, Rational(-3, 4)}, Rational(5, 4)));
  CHECK(std::all_of(left.segments.begin(), left.segments.end(),
                    [](const Segment& s) { return sgn(s.b.y) >= 0; }));
}

TEST_CASE("a closed polyline with bulges is closed exactly, in both planes") {
  const std::string corners =
      "70 1 10 0.1 20 0.2 10 3.3 20 0.7 42 0.31 10 2.9 20 4.1 10 0 20 3 42 -0.77";
  const SegmentSet set = drawn("0 LWPOLYLINE 8 0 " + corners);
  CHECK(is_chain(set));
  CHECK(first(set) == last(set));
  const SegmentSet back = drawn("0 LWPOLYLINE 8 0 " + corners + " 210 0 220 0 230 -1");
  REQUIRE(back.segments.size() == set.segments.size());
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    CHECK(back.segments[i].a == Point{-set.segments[i].a.x, set.segments[i].a.y});
  }
  CHECK(ledger_of(set) == "bulge by chords, ");
}

TEST_CASE("an ELLIPSE is the affine image of the circle") {
  // Centre (1, 2), u = (3, 4), ratio 1/2: v = (-2, 3/2).
  const SegmentSet set =
      drawn("0 ELLIPSE 8 0 10 1 20 2 11 3 21 4 40 .5 41 0.0 42 6.283185307179586");
  CHECK(is_chain(set));
  CHECK(first(set) == last(set));
  CHECK(first(set) == Point{4, 6});
  for (const Segment& s : set.segments) {
    const Rational dx = s.a.x - 1;
    const Rational dy = s.a.y - 2;
    const Rational along = (3 * dx + 4 * dy) / 25;
    const Rational across = (-2 * dx + Rational(3, 2) * dy) / Rational(25, 4);
    CHECK(along * along + across * across == 1);
  }
  CHECK(ledger_of(set) == "ellipse by chords, end of a whole ellipse by its start, ");
}

TEST_CASE("an elliptic arc goes from its first parameter to its second, from u to v") {
  const std::string ellipse = "0 ELLIPSE 8 0 10 0 20 0 11 2 21 0 40 0.5 41 0 42 1.570796326794897";
  const SegmentSet quarter = drawn(ellipse);
  CHECK(first(quarter) == Point{2, 0});
  CHECK(plumbline::nearest_double(last(quarter).y) == Approx(1).margin(1e-14));
  CHECK(plumbline::nearest_double(last(quarter).x) == Approx(0).margin(1e-14));
  const SegmentSet back = drawn(ellipse + " 210 0 220 0 230 -1");
  CHECK(first(back) == Point{2, 0});
  CHECK(plumbline::nearest_double(last(back).y) == Approx(-1).margin(1e-14));
  const SegmentSet rest =
      drawn("0 ELLIPSE 8 0 10 0 20 0 11 2 21 0 40 0.5 41 3.14159265358979 42 0");
  CHECK(std::all_of(rest.segments.begin(), rest.segments.end(),
                    [](const Segment& s) { return sgn(s.b.y) <= 0; }));
  CHECK(last(rest) == Point{2, 0});
  CHECK(rejected("0 ELLIPSE 8 0 10 0 20 0 11 0 21 0 40 0.5") ==
        "a.dxf:6 ELLIPSE (0): ellipse with an axis of no length\n");
  CHECK(rejected("0 ELLIPSE 8 0 10 0 20 0 11 1 21 0 40 0.5 41 1 42 1") ==
        "a.dxf:6 ELLIPSE (0): ellipse of no angle: group 42: 1\n");
}

TEST_CASE("a SPLINE of one piece is its Bezier curve") {
  // y = x (2 - x) over [0, 2].
  const SegmentSet set =
      drawn("0 SPLINE 8 0 71 2 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 1 20 2 10 2 20 0");
  CHECK(is_chain(set));
  CHECK(first(set) == Point{0, 0});
  CHECK(last(set) == Point{2, 0});
  for (const Segment& s : set.segments) CHECK(s.a.y == s.a.x * (2 - s.a.x));
  CHECK(set.segments.size() > 8);
  CHECK(ledger_of(set) == "spline by chords, ");
}

TEST_CASE(
    "a SPLINE with weights is exact: a quarter of a circle has no rational weights, 3/5 has") {
  // Weight 4/5 between (1, 0) and (7/25, 24/25): the arc of the unit circle of angle 2 acos(4/5).
  const SegmentSet set = drawn(
      "0 SPLINE 8 0 70 4 71 2 40 0 40 0 40 0 40 2 40 2 40 2 41 1 41 .8 41 1 10 1 20 0 "
      "10 1 20 .75 10 .28 20 .96");
  CHECK(is_on_circle(set, {0, 0}, 1));
  CHECK(last(set) == Point{Rational(7, 25), Rational(24, 25)});
}

TEST_CASE("inner knots join pieces exactly, also where the knots are not clamped") {
  // Uniform quadratic B-spline of points on y = x^2 - 1/4: knots 0..5 give x = t - 3/2 on [2, 3].
  const SegmentSet set = drawn(
      "0 SPLINE 8 0 71 2 40 0 40 1 40 2 40 3 40 4 40 5 40 6 10 0 20 0 10 1 20 1 10 2 20 4 "
      "10 3 20 9");
  CHECK(is_chain(set));
  CHECK(first(set) == Point{Rational(1, 2), Rational(1, 2)});
  CHECK(last(set) == Point{Rational(5, 2), Rational(13, 2)});
  for (const Segment& s : set.segments) CHECK(s.a.y == s.a.x * s.a.x + Rational(1, 4));
}

TEST_CASE("splines that define no curve are refused with the reason") {
  const std::string points = " 10 0 20 0 10 1 20 2 10 2 20 0";
  CHECK(rejected("0 SPLINE 8 0 71 2 40 0 40 0 40 0 40 1 40 1" + points) ==
        "a.dxf:6 SPLINE (0): a spline of degree 2 with 3 control points and 5 knots\n");
  CHECK(rejected("0 SPLINE 8 0 71 2 40 0 40 0 40 2 40 1 40 1 40 1" + points) ==
        "a.dxf:6 SPLINE (0): knots out of order\n");
  CHECK(rejected("0 SPLINE 8 0 71 2 40 1 40 1 40 1 40 1 40 1 40 1" + points) ==
        "a.dxf:6 SPLINE (0): spline without extent: all its knots are equal\n");
  CHECK(rejected("0 SPLINE 8 0 71 2 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 0 41 1" + points) ==
        "a.dxf:6 SPLINE (0): a weight of the spline is not positive\n");
  CHECK(rejected("0 SPLINE 8 0 71 5000 40 0" + points) ==
        "a.dxf:6 SPLINE (0): degree of the spline: 5000\n");
  CHECK(rejected("0 SPLINE 8 0 71 3 11 0 21 0 11 1 21 1") ==
        "a.dxf:6 SPLINE (0): spline by fit points only\n");
}

TEST_CASE("a smaller tolerance makes more chords, all still on the curve") {
  const SegmentSet coarse = drawn("0 CIRCLE 8 0 10 0 20 0 40 1", Rational(1, 10));
  const SegmentSet fine = drawn("0 CIRCLE 8 0 10 0 20 0 40 1", Rational(1, 100'000));
  CHECK(coarse.segments.size() < 20);
  CHECK(fine.segments.size() > 500);
  CHECK(is_on_circle(fine, {0, 0}, 1));
  CHECK(2 * kPi - length(fine) < 1e-4);
}

TEST_CASE("curves in blocks are flattened once and placed exactly") {
  const SegmentSet set = evaluate(read_dxf(
      dxf_with("0 INSERT 2 B 10 10 20 0 0 INSERT 2 B 10 0 20 10 41 2 42 2",
               "0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 0 20 0 0 CIRCLE 8 0 10 0 20 0 40 1 0 ENDBLK "
               "0 ENDSEC"),
      "a.dxf"));
  REQUIRE(set.segments.size() % 2 == 0);
  const std::size_t half = set.segments.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    const Point small = set.segments[i].a;
    CHECK(set.segments[half + i].a == Point{2 * (small.x - 10), 2 * small.y + 10});
  }
}

TEST_CASE("a small curve of a large drawing is drawn as the drawing needs it") {
  const auto chords = [](const std::string& frame, const std::string& block) {
    const std::string blocks =
        "0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 0 20 0 0 CIRCLE 8 0 10 0 20 0 40 1 "
        "0 ENDBLK 0 ENDSEC";
    return evaluate(read_dxf(dxf_with(frame + block, blocks), "a.dxf")).segments.size() -
           (frame.empty() ? 0 : 1);
  };
  const std::string insert = "0 INSERT 2 B 10 500 20 0";
  const std::string enlarged = insert + " 41 120 42 120";
  const std::string diagonal = "0 LINE 8 0 10 0 20 150 11 1000 21 160 ";
  CHECK(chords("", insert) > 48);        // 0.001 x 2
  CHECK(chords(diagonal, insert) < 20);  // 0.0002 x 1000, a tenth of the circle
  CHECK(chords(diagonal, insert) >= 12);
  CHECK(chords(diagonal, enlarged) == chords("", insert));  // the drawing is 4 times the circle
  // What is far away is not a part of the drawing.
  const std::string stray = "0 LINE 8 0 10 90000 20 0 11 90001 21 0 ";
  const std::string house =
      " 0 LINE 8 0 10 499 20 -2 11 501 21 -2 0 LINE 8 0 10 499 20 2 11 501 21 2";
  CHECK(chords(stray, insert + house) == chords("", insert + house));
}

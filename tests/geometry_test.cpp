#include "plumbline/geometry.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "plumbline/error.hpp"

using plumbline::on_segment;
using plumbline::orientation;
using plumbline::parse_decimal;
using plumbline::Point;
using plumbline::PointD;
using plumbline::Rational;
using plumbline::Segment;
using plumbline::SegmentSet;
using plumbline::Source;
using plumbline::squared_distance;

namespace {

/// "x y" as a point.
Point point(const std::string& text) {
  const auto blank = text.find(' ');
  return {parse_decimal(text.substr(0, blank)), parse_decimal(text.substr(blank + 1))};
}

}  // namespace

TEST_CASE("points compare lexicographically by x, then y") {
  CHECK(point("1 2") < point("1 3"));
  CHECK(point("1/3 9") < point("0.34 0"));
  CHECK_FALSE(point("1 2") < point("1 2"));
}

TEST_CASE("orientation tells left from right at any distance from the line") {
  CHECK(orientation(point("0 0"), point("1 0"), point("5 1e-400")) == 1);
  CHECK(orientation(point("0 0"), point("1 0"), point("5 -1e-400")) == -1);
  CHECK(orientation(point("0 0"), point("3 1"), point("1 1/3")) == 0);
  CHECK(orientation(point("0.1 0.1"), point("0.2 0.2"), point("0.3 0.3")) == 0);
  CHECK(orientation(point("1 1"), point("1 1"), point("2 5")) == 0);
  CHECK(orientation(point("1e300 0"), point("1e310 1"), point("-1e305 2")) == 1);
}

TEST_CASE("orientation is right for points one unit in the last place off the line") {
  // Points of Kettner, Mehlhorn, Pion, Schirra, Yap, Classroom examples of robustness problems in
  // geometric computations, 2008, fig. 2a: 0.5 + (x, y) 2^-53 against the line y = x, where double
  // arithmetic errs about half the time.
  const double unit = std::ldexp(1.0, -53);
  const Point q = plumbline::exact(PointD{12, 12});
  const Point r = plumbline::exact(PointD{24, 24});
  for (int x = 0; x < 64; ++x) {
    for (int y = 0; y < 64; ++y) {
      const Point p = plumbline::exact(PointD{0.5 + x * unit, 0.5 + y * unit});
      const int expected = p.x < p.y ? 1 : (p.y < p.x ? -1 : 0);  // p above y = x is on its left
      REQUIRE(orientation(q, r, p) == expected);
      REQUIRE(orientation(p, q, r) == expected);
      REQUIRE(orientation(q, p, r) == -expected);
    }
  }
}

TEST_CASE("the closed segment holds its ends and what lies between, nothing else") {
  const Point p = point("0 0");
  const Point q = point("3 -1");
  CHECK(on_segment(p, q, p));
  CHECK(on_segment(p, q, q));
  CHECK(on_segment(p, q, point("1 -1/3")));
  CHECK(on_segment(q, p, point("1 -1/3")));
  CHECK_FALSE(on_segment(p, q, point("6 -2")));
  CHECK_FALSE(on_segment(p, q, point("-3 1")));
  CHECK_FALSE(on_segment(p, q, point("1 -0.3333333333333333333333333")));
  CHECK(on_segment(p, p, p));
  CHECK_FALSE(on_segment(p, p, q));
}

TEST_CASE("squared distances to a segment are those to its nearest point") {
  const Point a = point("0 0");
  const Point b = point("4 3");
  CHECK(squared_distance(a, b) == 25);
  CHECK(squared_distance(point("-1 -2"), a, b) == 5);
  CHECK(squared_distance(point("4 5"), a, b) == 4);
  CHECK(squared_distance(point("-0.6 0.8"), a, b) == 1);
  CHECK(squared_distance(point("2 1.5"), a, b) == 0);
  CHECK(squared_distance(point("1 0"), a, b) == parse_decimal("9/25"));
  CHECK(squared_distance(point("3 4"), a, a) == 25);
}

TEST_CASE("a point rounds to the nearest doubles and a double point is taken exactly") {
  CHECK(plumbline::nearest(point("1/3 0.1")) == PointD{1.0 / 3.0, 0.1});
  CHECK(plumbline::to_text(plumbline::exact(PointD{0.5, -2})) == "0.5 -2");
  CHECK_THROWS_AS(plumbline::exact(PointD{0, std::nan("")}), plumbline::Error);
}

TEST_CASE("a segment set keeps segments with their sources and lists what it refuses") {
  SegmentSet set;
  const auto file = set.add_file("plan.svg");
  const auto source = set.add_source({file, 3, 5, "line", "w1", "walls"});
  set.add(Segment{point("0 0"), point("0.1 1/3")}, source);
  set.add(PointD{0.5, 0}, PointD{0.25, 0}, source);
  set.add(Segment{point("1 2"), point("1 2")}, source);
  set.add(PointD{1, 2}, PointD{1, 2}, source);
  set.add(PointD{0, 0}, PointD{std::numeric_limits<double>::infinity(), 1}, source);
  set.add_point(point("7 7"), source);

  std::string accepted;
  for (const Segment& s : set.segments) accepted += plumbline::to_text(s) + "\n";
  CHECK(accepted == "0 0, 0.1 1/3\n0.5 0, 0.25 0\n");
  CHECK(set.segment_source == std::vector{source, source});
  CHECK(plumbline::to_text(set.points.at(0)) == "7 7");
  std::string refused;
  for (const auto& item : set.rejected) {
    refused += to_text(item.source, set.files) + ": " + item.reason + ": " + item.text + "\n";
  }
  CHECK(refused ==
        "plan.svg:3:5 line #w1 (walls): zero-length segment: 1 2, 1 2\n"
        "plan.svg:3:5 line #w1 (walls): zero-length segment: 1 2, 1 2\n"
        "plan.svg:3:5 line #w1 (walls): coordinate is not a finite number: 0 0, inf 1\n");
}

TEST_CASE("a list of segments gives back what it was given, decimals and others") {
  const Segment s{point("0.10 -2"), point("1/3 9223372036854775808")};
  const Segment t{point("0 0"), point("1e-30 7")};
  plumbline::SegmentList list{s};
  list.push_back(t);
  CHECK(list.size() == 2);
  CHECK(list[0] == s);
  CHECK(list.at(1) == t);
  CHECK_THROWS_AS(list.at(2), std::out_of_range);
  CHECK(list.numbers(0)[0].mantissa() == 1);
  CHECK(list.numbers(0)[0].digits() == 1);
  CHECK_FALSE(list.numbers(0)[2].is_decimal());
  CHECK(std::vector<Segment>(list.begin(), list.end()) == std::vector{s, t});
  CHECK(list == plumbline::SegmentList{s, t});
  CHECK_FALSE(list == plumbline::SegmentList{t, s});
}

TEST_CASE("a list of sources gives back what it was given, whatever repeats") {
  std::mt19937 random(3);
  const auto name = [&](unsigned count) {
    return std::string(random() % 4 == 0 ? 0 : 1 + random() % 40,
                       static_cast<char>('a' + random() % count));
  };
  std::vector<Source> given;
  plumbline::SourceList list;
  for (int i = 0; i < 1000; ++i) {
    given.push_back({static_cast<std::uint32_t>(random() % 3), static_cast<std::uint32_t>(random()),
                     static_cast<std::uint32_t>(random()), name(3), name(26), name(2)});
    list.push_back(given.back());
  }
  const plumbline::SourceList copy = list;
  CHECK(std::vector<Source>(copy.begin(), copy.end()) == given);
  CHECK(copy.at(999) == given[999]);
  CHECK_THROWS_AS(copy.at(1000), std::out_of_range);
}

TEST_CASE("the text of a rejected item is shortened") {
  SegmentSet set;
  const auto source = set.add_source({});
  const Point far = point(std::string(200, '7') + " 1");
  set.add(Segment{far, far}, source);
  CHECK(set.rejected.at(0).text == std::string(57, '7') + "...");
}

TEST_CASE("a source's text leaves out what is unknown") {
  const std::vector<std::string> files{"a.svg"};
  CHECK(to_text(Source{0, 3, 0, "row", "", ""}, files) == "a.svg:3 row");
  CHECK(to_text(Source{0, 0, 0, "", "x", ""}, files) == "a.svg #x");
  CHECK(to_text(Source{4, 0, 0, "", "", "g/h"}, files) == "(g/h)");
}

// Transform lists, through read_svg. The cases follow SVG 1.1, 7.6 and 7.6.1.

#include <catch2/catch.hpp>

#include "plumbline/read.hpp"
#include "support/listing.hpp"

using plumbline::evaluate;
using plumbline::read_svg;

namespace {

plumbline::SegmentSet drawn(const std::string& transform) {
  return evaluate(read_svg(
      "<svg><g id='g' transform='" + transform + "'><line x1='1' y1='2' x2='3' y2='5'/></g></svg>",
      "a.svg"));
}

/// Where the transform takes the points (1, 2) and (3, 5).
std::string mapped(const std::string& transform) {
  const auto set = drawn(transform);
  REQUIRE(rejected_of(set).empty());
  return to_text(set.segments.at(0));
}

}  // namespace

TEST_CASE("every transform function maps exactly") {
  const auto [transform, segment] = GENERATE(table<std::string, std::string>({
      {"", "1 2, 3 5"},
      {"matrix(1 2 3 4 5 6)", "12 16, 23 32"},
      {"translate(10,.5)", "11 2.5, 13 5.5"},
      {"translate(10)", "11 2, 13 5"},
      {"scale(2,-1)", "2 -2, 6 -5"},
      {"scale(.1)", "0.1 0.2, 0.3 0.5"},
      {"rotate(90)", "-2 1, -5 3"},
      {"rotate(-90)", "2 -1, 5 -3"},
      {"rotate(180)", "-1 -2, -3 -5"},
      {"rotate(90 1 2)", "1 2, -2 4"},
      {"rotate(540, 10, 10)", "19 18, 17 15"},
      {"skewX(45)", "3 2, 8 5"},
      {"skewY(45)", "1 3, 3 8"},
      {"skewX(-45)", "-1 2, -2 5"},
  }));
  CAPTURE(transform);
  CHECK(mapped(transform) == segment);
  CHECK(drawn(transform).ledger.empty());
}

TEST_CASE("the last function of a list is applied first") {
  CHECK(mapped("translate(10 0) scale(2)") == "12 4, 16 10");
  CHECK(mapped("scale(2) translate(10 0)") == "22 4, 26 10");
  CHECK(mapped("translate(10 0) rotate(90) scale(2)") == "6 2, 0 6");
}

TEST_CASE("functions and arguments are separated as the grammar says") {
  const std::string same =
      GENERATE(as<std::string>{}, "translate(10,20)scale(2)", "translate(10 20) scale(2)",
               " translate (10 , 20 ) , scale( 2 ) ", "translate(10,20),scale(2,2)",
               "translate(10,20),,\n,scale(2)", "translate(10+20)\tscale(2 2.)",
               "translate(1e1 2E1)scale(2)");
  CAPTURE(same);
  CHECK(mapped(same) == "12 24, 16 30");
}

TEST_CASE("a malformed transform rejects the element with all that is in it") {
  const auto [transform, reason] = GENERATE(table<std::string, std::string>({
      {"translate(1,2", "malformed transform"},
      {"translate 1 2", "malformed transform: translate 1 2"},
      {"translate(1,,2)", "malformed transform: ,2)"},
      {"translate(1,2,)", "malformed transform: )"},
      {"translate(,1)", "malformed transform: ,1)"},
      {"(1)", "malformed transform: (1)"},
      {"scale(2),", "malformed transform: scale(2),"},
      {",scale(2)", "malformed transform: ,scale(2)"},
      {"rotate(30deg)", "malformed transform: deg)"},
      {"translate()", "wrong number of arguments in transform: translate()"},
      {"translate(1 2 3)", "wrong number of arguments in transform: translate(1 2 3)"},
      {"rotate(1 2)", "wrong number of arguments in transform: rotate(1 2)"},
      {"matrix(1 2 3 4 5)", "wrong number of arguments in transform: matrix(1 2 3 4 5)"},
      {"skewx(3)", "unknown function in transform: skewx(3)"},
      {"scale(2) turn(1)", "unknown function in transform: turn(1)"},
      {"skewX(90)", "skew by a right angle: skewX(90)"},
      {"scale(1e99999)", "decimal exponent beyond 10000: 1e99999"},
      {"scale(1e9999) scale(1e9999) scale(1e9999) scale(1e9999)",
       "the product of the transform is too large: scale(1e9999) scale(1e9999) scale(1e9999) "
       "scale(1e9999)"},
  }));
  CAPTURE(transform);
  const auto set = drawn(transform);
  CHECK(set.segments.empty());
  CHECK(rejected_of(set) == "a.svg:1:6 g #g: " + reason + "\n");
}

TEST_CASE("an angle without rational sine and cosine is replaced, which the ledger says") {
  const auto set = drawn("translate(1) rotate(30)skewX(10)");
  REQUIRE(set.ledger.size() == 2);
  CHECK(to_text(set.ledger[0].source, set.files) == "a.svg:1:6 g #g");
  CHECK(set.ledger[0].what == "skewX(10)");
  CHECK(set.ledger[0].bound == "1e-15 (tangent)");
  CHECK(set.ledger[1].what == "rotation by 30 degrees");
  CHECK(set.ledger[1].bound == "1e-15 rad");
}

TEST_CASE("a rotation about a point keeps lengths exactly and that point in place") {
  const auto set = drawn("rotate(17.3 1 2)");
  const auto& segment = set.segments.at(0);
  CHECK(to_text(segment.a) == "1 2");
  CHECK(squared_distance(segment.a, segment.b) == 13);
}

TEST_CASE("a shape's own transform ends with the shape, inside the maps above it") {
  CHECK(segments_of(evaluate(read_svg("<svg><g transform='translate(10)'>"
                                      "<line x2='1' transform='scale(2)'/><line x2='1'/></g>"
                                      "<line x2='1'/></svg>",
                                      "a.svg"))) == "10 0, 12 0\n10 0, 11 0\n0 0, 1 0\n");
}

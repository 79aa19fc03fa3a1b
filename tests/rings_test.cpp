#include "plumbline/rings.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "plumbline/arrange.hpp"
#include "plumbline/read.hpp"

using namespace plumbline;

namespace {

SegmentSet wkt(const std::string& text) { return evaluate(read_wkt(text, "a.wkt")); }
SegmentSet svg(const std::string& text) {
  return evaluate(read_svg("<svg xmlns='http://www.w3.org/2000/svg'>" + text + "</svg>", "a.svg"));
}

/// A line for each problem: what JTS calls it, where, and the sentence.
std::string problems(const SegmentSet& input) {
  std::string text;
  for (const RingProblem& problem : ring_problems(input, arrange(input))) {
    text += jts_name(problem.fault) + " [" + to_text(problem.where);
    if (problem.until) text += ", " + to_text(*problem.until);
    text += "]: " + describe(problem, input) + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("valid polygons have no problems") {
  CHECK(problems(wkt("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))")).empty());
  // A hole that touches the outer ring, and another hole, in one point each.
  CHECK(problems(
            wkt("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (0 4, 2 5, 2 3, 0 4), (2 5, 4 6, 4 4, 2 5))"))
            .empty());
  CHECK(problems(wkt("MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 8, 8 8, 8 1, 1 1)),"
                     "((2 2, 7 2, 7 7, 2 7, 2 2)), ((9 9, 10 9, 10 10, 9 9)))"))
            .empty());
  // Neighbours, and what lies over them, are polygons of their own.
  CHECK(problems(wkt("POLYGON ((0 0, 4 0, 4 4, 0 0)); POLYGON ((4 0, 8 0, 4 4, 4 0));"
                     "POLYGON ((1 -1, 5 -1, 5 5, 1 -1)); POLYGON ((0 0, 4 0, 4 4, 0 0))"))
            .empty());
  CHECK(problems(wkt("LINESTRING (0 0, 4 4, 4 0, 0 4)")).empty());
  CHECK(problems(wkt("TIN (((0 0, 4 0, 4 4, 0 0)), ((4 4, 4 0, 8 0, 4 4)))")).empty());
}

TEST_CASE("a ring that crosses itself does so in an exact place") {
  CHECK(problems(wkt("POLYGON ((233 115, 190 186, 247 260, 430 304, 531 244, 510 170, 415 104, "
                     "553 196, 233 115))")) ==
        "Self-intersection [11310867/21979 4094368/21979]: outer ring of Polygon crosses itself\n");
  // In a vertex of both parts.
  CHECK(problems(wkt("POLYGON ((0 0, 2 2, 4 4, 4 0, 2 2, 0 4, 0 0))")) ==
        "Self-intersection [2 2]: outer ring of Polygon crosses itself\n");
  CHECK(problems(wkt("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (4 4, 12 4, 4 6, 4 4))")) ==
        "Self-intersection [9 4]: hole 1 of Polygon crosses the outer ring\n"
        "Self-intersection [9 4.75]: hole 1 of Polygon crosses the outer ring\n");
}

TEST_CASE("a ring that touches itself does not cross itself") {
  CHECK(problems(wkt("POLYGON ((0 0, 2 2, 0 4, 4 4, 2 2, 4 0, 0 0))")) ==
        "Ring Self-intersection [2 2]: outer ring of Polygon touches itself\n");
  // A vertex on a side.
  CHECK(problems(wkt("POLYGON ((0 0, 9 0, 9 9, 5 0, 0 9, 0 0))")) ==
        "Ring Self-intersection [5 0]: outer ring of Polygon touches itself\n");
}

TEST_CASE("rings that run along each other are told where from and where to") {
  CHECK(problems(wkt("MULTIPOLYGON (((0 0, 1 -1, 2 2, 0 0), (0.3 0.3, 0.6 0.6, 0.5 -0.5, 0.3 "
                     "0.3)))")) ==
        "Self-intersection [0.3 0.3, 0.6 0.6]: hole 1 of MultiPolygon runs along the outer ring\n"
        "Interior is disconnected [0.5 -0.5]: hole 1 of MultiPolygon and the outer ring cut the "
        "interior in two\n");
  // A spike.
  CHECK(problems(wkt("POLYGON ((0 0, 9 0, 9 4, 12 4, 9 4, 9 9, 0 0))")) ==
        "Self-intersection [9 4, 12 4]: outer ring of Polygon runs along itself\n");
}

TEST_CASE("rings lie where they should") {
  CHECK(problems(wkt("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (10 0, 12 0, 12 2, 10 0))")) ==
        "Hole lies outside shell [10 0]: hole 1 of Polygon lies outside the outer ring\n");
  // All its corners are on the outer ring.
  CHECK(problems(wkt("POLYGON ((0 0, 9 0, 9 9, 5 4, 0 9, 0 0), (0 9, 5 4, 9 9, 0 9))"))
            .starts_with("Self-intersection [0 9, 9 9]"));
  CHECK(problems(wkt("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 8, 8 8, 8 1, 1 1),"
                     "(2 2, 2 3, 3 3, 2 2))")) ==
        "Holes are nested [2 2]: hole 2 of Polygon lies in hole 1\n");
  CHECK(
      problems(wkt("MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0)), ((1 1, 2 1, 2 2, 1 1)))")) ==
      "Nested shells [1 1]: outer ring of part 2 of MultiPolygon #2 lies in the outer ring of part "
      "1\n");
}

TEST_CASE("holes in a row from side to side cut the interior in two") {
  CHECK(problems(wkt(
            "POLYGON ((0 0, 8 0, 8 9, 0 9, 0 0), (0 4, 4 6, 4 2, 0 4), (4 6, 8 4, 4 7, 4 6))")) ==
        "Interior is disconnected [8 4]: hole 2 of Polygon and the outer ring cut the interior in "
        "two\n");
}

TEST_CASE("a ring may be open, or have too few points") {
  CHECK(problems(wkt("MULTIPOLYGON (((0 0, 0 1, 3 1, 3 0)))")) ==
        "Ring is not closed [3 0]: outer ring of MultiPolygon is not closed\n");
  CHECK(problems(wkt("POLYGON ((0 0, 4 0, 0 0))")) ==
        "Too few points in geometry component [0 0]: outer ring of Polygon has less than "
        "three distinct points\n");
}

TEST_CASE("a ring without length is told beside one that has some") {
  CHECK(problems(wkt("POLYGON ((0 0, 4 0, 4 4, 0 0), (1 1, 1 1, 1 1, 1 1))")) ==
        "Too few points in geometry component [0 0]: hole 1 of Polygon has less than three "
        "distinct points\n");
  CHECK(problems(wkt("POLYGON ((1 1, 1 1, 1 1, 1 1)); LINESTRING (0 0, 1 0)")).empty());
}

TEST_CASE("closed lines of drawings are rings") {
  CHECK(problems(svg("<polygon id='p' points='0,0 4,4 4,0 0,4'/>")) ==
        "Self-intersection [2 2]: closed line of polygon #p crosses itself\n");
  CHECK(problems(svg("<path d='M9 9 L8 8 M0 0 L4 4 V0 L0 4 Z'/>")) ==
        "Self-intersection [2 2]: closed line of path crosses itself\n");
  CHECK(problems(svg("<polyline points='0,0 4,4 4,0 0,4'/>")).empty());
  CHECK(svg("<rect width='4' height='4'/><circle r='4'/>").rings ==
        std::vector<Ring>{{0, 4, RingRole::Line}});
}

TEST_CASE("rings keep their segments where others get lost or are added") {
  // A point twice; behind a circle that a line joins; mapped.
  CHECK(problems(wkt("POLYGON ((0 0, 4 4, 4 4, 4 0, 0 4, 0 0))")) ==
        "Self-intersection [2 2]: outer ring of Polygon crosses itself\n");
  CHECK(problems(svg(
            "<circle r='4'/><path d='M4 0 H9'/>"
            "<g transform='translate(10 0) scale(2)'><polygon points='0,0 4,4 4,0 0,4'/></g>")) ==
        "Self-intersection [14 4]: closed line of polygon crosses itself\n");
}

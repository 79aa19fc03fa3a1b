#include <catch2/catch.hpp>

#include "cases/foreign/foreign.hpp"
#include "foreign/claims.hpp"
#include "plumbline/output.hpp"

using namespace plumbline::foreign;
using plumbline::Error;

namespace {

std::string rows(const Case& one) { return to_lines(one.input); }

}  // namespace

TEST_CASE("a JTS test file gives the lines of a and b, and what it says of them") {
  const auto cases = jts_xml(R"(<run><desc>x</desc>
    <case><desc> two </desc>
      <a>LINESTRING (0 0, 1 0.5)</a>
      <b>010200000002000000000000000000F03F000000000000000000000000000000400000000000000840</b>
      <test><op name="isValid" arg1="A"> true </op></test>
      <test><op name="relate" arg1="A" arg2="B">FF1FF0102</op></test>
    </case>
    <case><a>POLYGON ((0 0, 1 0, 0 1, 0 0))'</a>
      <test><op name='isSimple' arg1='A'>false</op></test></case></run>)");
  REQUIRE(cases.size() == 2);
  CHECK(cases[0].name == "two");
  CHECK(rows(cases[0]) == "0,0,1,0.5\n1,0,2,3\n");
  REQUIRE(cases[0].claims.size() == 1);
  CHECK(cases[0].claims[0].kind == Claim::Kind::Valid);
  CHECK(cases[0].claims[0].holds);
  CHECK(cases[0].unexamined == std::vector<std::string>{"relate"});
  CHECK(rows(cases[1]) == "0,0,1,0\n1,0,0,1\n0,1,0,0\n");
  REQUIRE(cases[1].input.rejected.size() == 1);
  CHECK(cases[1].input.rejected[0].reason == "text after a geometry");
  CHECK_FALSE(cases[1].claims.at(0).holds);
}

TEST_CASE("a JTS test of an operation on polygons gives the area of the result that it expects") {
  const auto cases = jts_xml(R"(<run><case><a>POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))</a>
      <b>POLYGON ((1 1, 3 1, 3 3, 1 3, 1 1))</b>
      <test><op name="intersection" arg1="A" arg2="B">POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))</op></test>
      <test><op name="differenceNG" arg1="B" arg2="A">
        POLYGON ((2 1, 3 1, 3 3, 1 3, 1 2, 2 2, 2 1))</op></test>
      <test><op name="union" arg1="A">POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))</op></test>
    </case></run>)");
  REQUIRE(cases.at(0).areas.size() == 2);
  CHECK(cases[0].areas[0].area == 1);
  CHECK(clipped_area(cases[0].input, cases[0].areas[0]).area == 1);
  CHECK(cases[0].areas[1].area == 3);
  CHECK(cases[0].areas[1].operation == AreaClaim::Operation::ReverseDifference);
  CHECK(clipped_area(cases[0].input, cases[0].areas[1]).area == 3);
  CHECK(cases[0].unexamined == std::vector<std::string>{"union"});
}

TEST_CASE("areas are those of shells less their holes") {
  CHECK(area(geometry("POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0), (1 1, 1 2, 2 2, 1 1))")) ==
        plumbline::Rational(17, 2));
  CHECK(perimeter(geometry("POLYGON ((0 0, 3 0, 3 4, 0 0))")) == 12);
  CHECK(area(geometry("GEOMETRYCOLLECTION (POINT (1 1), POLYGON ((0 0, 1 0, 0 1, 0 0)), "
                      "MULTIPOLYGON (((0 0, 0 2, 2 0, 0 0)), EMPTY))")) ==
        plumbline::Rational(5, 2));
}

TEST_CASE("a geometry that cannot be read is rejected, and the others are kept") {
  const auto cases = jts_xml(
      "<run><case><a>LINESTRING (0 0, x 1)</a><b>LINESTRING (0 0, 1 1)</b>"
      "</case></run>");
  CHECK(rows(cases.at(0)) == "0,0,1,1\n");
  CHECK(cases[0].input.rejected.size() == 1);
  CHECK_THROWS_AS(jts_xml("<run><case>"), Error);
  CHECK_THROWS_AS(jts_xml("<tests/>"), Error);
}

TEST_CASE("Clipper2's text gives closed and open paths, and an area where none is open") {
  const auto cases = clipper2(
      "CAPTION: 1. \nCLIPTYPE: DIFFERENCE\nFILLRULE: EVENODD\nSOL_AREA: 3\nSOL_COUNT: 1\n"
      "SUBJECTS\n0,0, 2,0, 2,2, 0,2\nCLIPS\n1,1 3,1 3,3 1,3\n\n"
      "CAPTION: 2.\r\nCLIPTYPE: UNION\r\nFILLRULE: NONZERO\r\nSOL_AREA: 8\r\nSUBJECTS_OPEN\r\n"
      "6,7, 6,5, 7,5\r\n");
  REQUIRE(cases.size() == 2);
  CHECK(cases[0].input.segments.size() == 8);
  REQUIRE(cases[0].areas.size() == 1);
  CHECK(cases[0].areas[0].area == 3);
  CHECK(cases[0].areas[0].first_clip == 4);
  const ClippedArea found = clipped_area(cases[0].input, cases[0].areas[0]);
  CHECK(found.area == 3);
  CHECK(found.perimeter == Approx(8));
  CHECK(rows(cases[1]) == "6,7,6,5\n6,5,7,5\n");
  CHECK(cases[1].areas.empty());
  CHECK_THROWS_AS(clipper2("SUBJECTS\n0,0, 1,1\n"), Error);
  CHECK_THROWS_AS(clipper2("CAPTION: 1.\nCLIPTYPE: UNION\nFILLRULE: ODD\n"), Error);
}

TEST_CASE("boolean operations by winding numbers have the areas of elementary geometry") {
  // Two squares of side 2 that share a square of side 1; the first one drawn twice.
  const std::string squares =
      "SUBJECTS\n0,0, 2,0, 2,2, 0,2\n0,0, 2,0, 2,2, 0,2\nCLIPS\n1,1, 3,1, 3,3, 1,3\n";
  const auto area = [&](const std::string& operation, const std::string& rule) {
    const auto cases = clipper2("CAPTION: 1.\nCLIPTYPE: " + operation + "\nFILLRULE: " + rule +
                                "\nSOL_AREA: 0\n" + squares);
    return clipped_area(cases.at(0).input, cases[0].areas.at(0)).area;
  };
  CHECK(area("INTERSECTION", "NONZERO") == 1);
  CHECK(area("UNION", "NONZERO") == 7);
  CHECK(area("DIFFERENCE", "NONZERO") == 3);
  CHECK(area("XOR", "NONZERO") == 6);
  CHECK(area("UNION", "EVENODD") == 4);  // twice is not at all
  CHECK(area("UNION", "POSITIVE") == 7);
  CHECK(area("UNION", "NEGATIVE") == 0);
}

TEST_CASE("CDT's text gives its points and edges, poly2tri's a closed path") {
  const auto cases = cdt("3 2\n0 0\n1.5 0\n1 1e1\n0 1\n1 2\n");
  CHECK(rows(cases.at(0)) == "0,0,1.5,0\n1.5,0,1,10\n0,0\n1.5,0\n1,10\n");
  CHECK_THROWS_AS(cdt("2 1\n0 0\n1 1\n0 2\n"), Error);
  CHECK_THROWS_AS(cdt("2 1\n0 0\n1 1\n"), Error);
  CHECK_THROWS_AS(cdt("1 0\n0 0\n1 1\n"), Error);
  CHECK(rows(poly2tri("0 0\n1 0\n0 1\n").at(0)) == "0,0,1,0\n1,0,0,1\n0,1,0,0\n");
  CHECK_THROWS_AS(poly2tri("0 0\n1\n"), Error);
}

TEST_CASE("iOverlay's JSON gives closed bodies and open strings, exactly as written") {
  const auto cases = ioverlay(
      R"({"fillRule": 0, "body": [[[0, 0], [0.1, 0], [0, 1]]], "string": [[[5, 5], [6, 6]]],
          "slice": [[[[9, 9]]]]})");
  CHECK(rows(cases.at(0)) == "0,0,0.1,0\n0.1,0,0,1\n0,1,0,0\n5,5,6,6\n");
  CHECK_THROWS_AS(ioverlay("{}"), Error);
  CHECK_THROWS_AS(ioverlay(R"({"body": [[[0]]]})"), Error);
  CHECK_THROWS_AS(ioverlay("{"), Error);
}

// The geometries are textbook examples of OGC SFA 1.2.1, 6.1.11 and 6.1.14.
TEST_CASE("polygons are valid if their interior is connected and rings touch in points only") {
  const auto valid = [](const char* wkt) { return is_valid(geometry(wkt)); };
  CHECK(valid("POLYGON EMPTY"));
  CHECK(valid("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 2 1, 2 2, 1 1))"));
  CHECK(valid("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (0 0, 2 1, 1 2, 0 0))"));
  CHECK(valid("MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((1 0, 2 0, 2 1, 1 0)))"));
  // An island in a hole.
  CHECK(
      valid("MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1)), "
            "((2 2, 7 2, 7 7, 2 2)))"));
  CHECK_FALSE(valid("POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))"));                   // a bow tie
  CHECK_FALSE(valid("POLYGON ((0 0, 9 0, 9 9, 0 9))"));                        // not closed
  CHECK_FALSE(valid("POLYGON ((0 0, 9 0, 9 9, 9 0, 0 9, 0 0))"));              // a spike
  CHECK_FALSE(valid("POLYGON ((0 0, 9 0, 9 9, 0 0), (0 5, 1 5, 1 6, 0 5))"));  // a hole outside
  CHECK_FALSE(
      valid("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1), "
            "(2 2, 7 2, 7 7, 2 2))"));  // a hole in a hole
  CHECK_FALSE(valid("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (0 0, 5 4, 9 9, 4 5, 0 0))"));  // in two
  CHECK_FALSE(valid("MULTIPOLYGON (((0 0, 9 0, 9 9, 0 0)), ((5 1, 8 1, 8 2, 5 1)))"));
  CHECK_FALSE(valid("MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((1 0, 0 1, 1 1, 1 0)))"));  // a side
  CHECK_FALSE(valid("LINESTRING (1 1, 1 1)"));
}

TEST_CASE("lines are simple if they meet in ends only") {
  const auto simple = [](const char* wkt) { return is_simple(geometry(wkt)); };
  CHECK(simple("LINESTRING (0 0, 1 1, 1 0, 0 0)"));
  CHECK(simple("LINESTRING (0 0, 1 1, 1 1, 2 1)"));
  CHECK(simple("MULTILINESTRING ((0 0, 1 1), (1 1, 2 0), (1 1, 2 2))"));
  CHECK(simple("MULTIPOINT ((0 0), (1 1))"));
  CHECK_FALSE(simple("LINESTRING (0 0, 2 2, 2 0, 0 2)"));
  CHECK_FALSE(simple("LINESTRING (0 0, 2 0, 1 0)"));
  CHECK_FALSE(simple("LINESTRING (0 0, 2 0, 2 2, 1 0)"));
  CHECK_FALSE(simple("MULTILINESTRING ((0 0, 2 2), (1 1, 2 0))"));
  CHECK_FALSE(simple("MULTILINESTRING ((0 0, 1 1, 1 0, 0 0), (0 0, -1 0))"));
  CHECK_FALSE(simple("MULTIPOINT ((0 0), (0 0))"));
}

#include <catch2/catch.hpp>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "support/listing.hpp"

using plumbline::evaluate;
using plumbline::listing;
using plumbline::read_csv;

namespace {

std::string listed(const std::string& text) { return listing(read_csv(text, "a.csv")); }

std::string error_of(const std::string& text) {
  try {
    read_csv(text, "a");
  } catch (const plumbline::Error& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("without a header a row is four numbers, as in .lines") {
  CHECK(listed("0,0,1,0.1\r\n\r\n 1e1 ,\t.5,-3 , 1/3\n\n5,5,6,6") ==
        "0 0, 1 0.1 | a.csv:1:1 row\n"
        "10 0.5, -3 1/3 | a.csv:3:1 row\n"
        "5 5, 6 6 | a.csv:5:1 row\n");
  CHECK(listed("").empty());
  CHECK(listed("\n \n").empty());
}

TEST_CASE("a header says which columns are coordinates and which the id") {
  CHECK(listed("layer,X1,Y1,\"x2\", y2 ,id\nwall,1,2,3,4,w-7\ndoor,5,6,7,8,\n") ==
        "1 2, 3 4 | a.csv:2:1 row #w-7\n5 6, 7 8 | a.csv:3:1 row\n");
  CHECK(listed("name;bx;by;ax;ay\n\"a \"\"b\"\"; c\";3;4;1;2\n") ==
        "1 2, 3 4 | a.csv:2:1 row #a \"b\"; c\n");
  CHECK(listed("ax\tay\tbx\tby\n1\t2\t3\t4") == "1 2, 3 4 | a.csv:2:1 row\n");
  CHECK(listed("sep=;\nx1;y1;x2;y2;a,b,c,d,e,f\n1;2;3;4;5\n") == "1 2, 3 4 | a.csv:3:1 row\n");
  CHECK(listed("x1,y1,x2,y2\n").empty());
}

TEST_CASE("RFC 4180: quoted fields hold separators, quotes and line ends") {
  CHECK(listed("id,x1,y1,x2,y2\n\"two\nlines, \"\"quoted\"\"\",1,2,\"3\",4\n\"\",5,6,7,8\r\n") ==
        "1 2, 3 4 | a.csv:2:1 row #two lines, \"quoted\"\n5 6, 7 8 | a.csv:4:1 row\n");
  CHECK(error_of("x1,y1,x2,y2\n1,2,3,4\n\"1,2,3,4\n5,6,7,8\n") == "a:3:1: a quote is not closed");
}

TEST_CASE("a geometry column holds WKT, or WKB in hexadecimal digits") {
  const std::string wkb =
      "01020000000200000000000000000000000000000000000000000000000000F03F000000000000F03F";
  CHECK(listed("gid,geom\n1,\"LINESTRING (0 0, 1 1, 2 0)\"\n2," + wkb +
               "\n3,\"GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0,\n0 1, 0 0)), POINT (1 2))\"\n4,\n5,"
               "\"LINESTRING (0 0, 1 x)\"\n6,\"LINESTRING (0 0, 1 1) 5\"\n7,\"CIRCLE\n(5)\"\n") ==
        "0 0, 1 1 | a.csv:2:3 LineString #1\n"
        "1 1, 2 0 | a.csv:2:3 LineString #1\n"
        "0 0, 1 1 | a.csv:3:3 LineString #2\n"
        "0 0, 1 1 | a.csv:8:3 LineString #6\n"
        "0 0, 1 0 | a.csv:4:3 Polygon #3\n"
        "1 0, 0 1 | a.csv:4:3 Polygon #3\n"
        "0 1, 0 0 | a.csv:4:3 Polygon #3\n"
        "rejected:\n"
        "a.csv:4:3 Point: isolated points are not drawn: 1 point\n"
        "a.csv:6:1 row #4: has no geometry\n"
        "a.csv:7:3 LineString: not a number: x\n"
        "a.csv:8:25 row #6: text behind the geometry: 5\n"
        "a.csv:9:3 row #7: not WKT: unknown geometry: CIRCLE\n");
}

TEST_CASE("a row that is not a segment is rejected with its place, the others are drawn") {
  CHECK(listed("1,2,3,4\n1,2,3\n1,2,3,4,5\n1,,3,4\n1,2,3,x\n\x01,\xff,0,0\n5,6,7,8\n") ==
        "1 2, 3 4 | a.csv:1:1 row\n5 6, 7 8 | a.csv:7:1 row\n"
        "rejected:\n"
        "a.csv:2:1 row: row of 3 values, not 4: 1\n"
        "a.csv:3:1 row: row of 5 values, not 4: 1\n"
        "a.csv:4:1 row: row without a value for one of x1, y1, x2, y2\n"
        "a.csv:5:1 row: not a number: x\n"
        "a.csv:6:1 row: not a number: ?\n");
  CHECK(listed("id;x1;y1;x2;y2\na;1,5;2;3;4\nb;1\nc;1;2;3;4;more\n") ==
        "1 2, 3 4 | a.csv:4:1 row #c\nrejected:\n"
        "a.csv:2:1 row #a: not a number: 1,5\n"
        "a.csv:3:1 row #b: row without a value for one of x1, y1, x2, y2\n");
}

TEST_CASE("a first row that is neither numbers nor a known header is refused") {
  const std::string message =
      ": the first row is neither four numbers nor a header with columns x1, y1, x2, y2 (or ax, "
      "ay, "
      "bx, by), or wkt: ";
  CHECK(error_of("x,y\n1,2\n") == "a:1:1" + message + "\"x\"");
  CHECK(error_of("\n1,2,3,4,5\n") == "a:2:1" + message + "\"1\"");
  CHECK(error_of("x1,y1,x2\n") == "a:1:1" + message + "\"x1\"");
  CHECK(error_of("1,2,3,x\n") == "a:1:1" + message + "\"1\"");
}

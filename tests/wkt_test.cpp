// Well-known text and well-known binary.

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "support/listing.hpp"

using plumbline::evaluate;
using plumbline::listing;
using plumbline::read_wkb;
using plumbline::read_wkt;

namespace {

std::string listed(const std::string& text) { return listing(read_wkt(text, "a.wkt")); }
std::string listed_wkb(const std::string& bytes) { return listing(read_wkb(bytes, "a.wkb")); }

template <class Reader>
std::string error_of(Reader reader, const std::string& text) {
  try {
    reader(text, "a", plumbline::ReadOptions{});
  } catch (const plumbline::Error& error) {
    return error.what();
  }
  return "accepted";
}

std::string wkt_error(const std::string& text) { return error_of(read_wkt, text); }
std::string wkb_error(const std::string& text) { return error_of(read_wkb, text); }

/// The bytes of well-known binary.
class Wkb {
 public:
  explicit Wkb(bool is_little_endian = true) : is_little_endian_(is_little_endian) {}
  Wkb& geometry(std::uint32_t type) {
    bytes += is_little_endian_ ? '\1' : '\0';
    return number(type);
  }
  Wkb& number(std::uint32_t value) { return append(value); }
  Wkb& point(double x, double y) {
    append(std::bit_cast<std::uint64_t>(x));
    return append(std::bit_cast<std::uint64_t>(y));
  }
  std::string bytes;

 private:
  template <class Integer>
  Wkb& append(Integer value) {
    for (std::size_t i = 0; i < sizeof(value); ++i) {
      const std::size_t byte = is_little_endian_ ? i : sizeof(value) - 1 - i;
      bytes += static_cast<char>(value >> (8 * byte));
    }
    return *this;
  }
  bool is_little_endian_;
};

std::string hex(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) {
    for (const unsigned digit :
         {static_cast<unsigned char>(c) / 16U, static_cast<unsigned char>(c) % 16U}) {
      text += "0123456789ABCDEF"[digit];
    }
  }
  return text;
}

}  // namespace

TEST_CASE("OGC SFA 1.2.1, table 6: each example has the segments of its lines") {
  const auto count = [](const std::string& text) {
    return evaluate(read_wkt(text, "a")).segments.size();
  };
  CHECK(count("Point (10 10)") == 0);
  CHECK(count("LineString ( 10 10, 20 20, 30 40)") == 2);
  CHECK(count("Polygon ((10 10, 10 20, 20 20, 20 15, 10 10))") == 4);
  CHECK(count("MultiPoint ((10 10), (20 20))") == 0);
  CHECK(count("MultiLineString ( (10 10, 20 20), (15 15, 30 15))") == 2);
  CHECK(count("MultiPolygon ( ((10 10, 10 20, 20 20, 20 15, 10 10)), ((60 60, 70 70, 80 60, 60 60 "
              ")))") == 7);
  CHECK(count("GeometryCollection ( POINT (10 10), POINT (30 30), LINESTRING (15 15, 20 20))") ==
        1);
}

TEST_CASE("geometries are elements with their places, exact, whatever is between them") {
  CHECK(listed("LINESTRING (0.1 1e-2, 1/3 -.5)\n\n# a comment (\n;  polygon\t((0 0,1 0\n, 0 1,0 0))"
               "\nSRID=4326;LINESTRING(7 7,8 8);") ==
        "0.1 0.01, 1/3 -0.5 | a.wkt:1:1 LineString\n"
        "7 7, 8 8 | a.wkt:6:1 LineString\n"
        "0 0, 1 0 | a.wkt:4:4 Polygon\n"
        "1 0, 0 1 | a.wkt:4:4 Polygon\n"
        "0 1, 0 0 | a.wkt:4:4 Polygon\n");
  CHECK(listed("").empty());
  CHECK(listed("\xEF\xBB\xBF# nothing").empty());
}

TEST_CASE("coordinates beyond x and y are noted, however their presence is written") {
  for (const char* text : {"LINESTRING Z (0 0 5, 1 1 6)", "LINESTRINGZ(0 0 5,1 1 6)",
                           "linestring zm (0 0 5 6, 1 1 6 7)", "LINESTRING (0 0 5, 1 1 6)",
                           "LINESTRINGM(0 0 5,1 1 6)"}) {
    CHECK(
        listed(text) ==
        "0 0, 1 1 | a.wkt:1:1 LineString\nremarks:\n"
        "a.wkt:1:1 LineString: coordinates beyond x and y are not used: 1 element from here on\n");
  }
}

TEST_CASE("what has no lines is listed, empty parts are passed over") {
  CHECK(listed("POINT (1 2)\nMULTIPOINT (1 2, (3 4), EMPTY)\nPOINT EMPTY\nLINESTRING EMPTY\n"
               "GEOMETRYCOLLECTION EMPTY\nMULTILINESTRING (EMPTY, (0 0, 1 1), EMPTY)\n"
               "CIRCULARSTRING (0 0, 1 1, 2 0)\n"
               "GEOMETRYCOLLECTION (CURVEPOLYGON Z (COMPOUNDCURVE ((0 0, 1 1), EMPTY)), "
               "LINESTRING (5 5, 6 6), GEOMETRYCOLLECTION EMPTY)\n"
               "POINT (nan nan)\nLINESTRING (0 0, 1 NaN)\nLINESTRING (1 1)") ==
        "5 5, 6 6 | a.wkt:8:1 LineString\n"
        "0 0, 1 1 | a.wkt:6:1 MultiLineString\n"
        "rejected:\n"
        "a.wkt:1:1 Point: isolated points are not drawn: 1 point\n"
        "a.wkt:2:1 MultiPoint: isolated points are not drawn: 2 points\n"
        "a.wkt:3:1 Point: isolated points are not drawn: 0 points\n"
        "a.wkt:4:1 LineString: has no points\n"
        "a.wkt:7:1 CIRCULARSTRING: curved geometry is not understood yet\n"
        "a.wkt:8:21 CURVEPOLYGON: curved geometry is not understood yet\n"
        "a.wkt:9:1 Point: not a number: nan\n"
        "a.wkt:10:1 LineString: not a number: NaN\n"
        "a.wkt:11:1 LineString: line of a single point: 1 line\n");
}

TEST_CASE("points and what is empty are harmless; curves and odd numbers are lost") {
  CHECK(lost_of(evaluate(read_wkt("POINT (1 2)\nLINESTRING EMPTY\nLINESTRING (1 1)\n"
                                  "LINESTRING (1 1, 1 1)\nPOLYGON ((0 0, 1 0, 1 1))",
                                  "a")))
            .empty());
  CHECK(lost_of(evaluate(read_wkt("CIRCULARSTRING (0 0, 1 1, 2 0)\nLINESTRING (0 0, 1 NaN)\n"
                                  "LINESTRING (0 0, 1e100 1)",
                                  "a"))) == "CIRCULARSTRING LineString LineString ");
}

TEST_CASE("a ring that is not closed is listed and not closed") {
  CHECK(listed("POLYGON ((0 0, 1 0, 1 1))") ==
        "0 0, 1 0 | a.wkt:1:1 Polygon\n1 0, 1 1 | a.wkt:1:1 Polygon\nremarks:\n"
        "a.wkt:1:1 Polygon: ring is not closed; it is drawn as it is: 1 ring\n");
  CHECK(listed("TRIANGLE ((0 0, 1.0 0, 1 1, 0 0.0))").find("closed") == std::string::npos);
}

TEST_CASE("a text that is not WKT is refused with its place") {
  CHECK(wkt_error("LINESTRING (0 0, 1 1)\nCIRCLE (0 0)") ==
        "a:2:1: not WKT: unknown geometry: \"CIRCLE\"");
  CHECK(wkt_error("LINESTRING (0 0, 1 1") == "a:1:21: not WKT: expected ',' or ')'");
  CHECK(wkt_error("LINESTRING (0 0 1 1 2 2)") ==
        "a:1:24: not WKT: position of 6 numbers, before this: \")\"");
  CHECK(wkt_error("LINESTRING (0, 1 1)").find("position of 1 numbers") != std::string::npos);
  CHECK(wkt_error("LINESTRING (0 0,, 1 1)").find("position of 0 numbers") != std::string::npos);
  CHECK(wkt_error("LINESTRING ((0 0, 1 1))") ==
        "a:1:14: not WKT: too many parentheses: \"0 0, 1 1))\"");
  CHECK(wkt_error("POLYGON (0 0, 1 1)") == "a:1:10: not WKT: expected '(': \"0 0, 1 1)\"");
  CHECK(wkt_error("LINESTRING 0 0") == "a:1:12: not WKT: expected '(': \"0 0\"");
  CHECK(wkt_error("LINESTRING (0 0, 1 1))") == "a:1:22: not WKT: unknown geometry: \")\"");
  CHECK(wkt_error("GEOMETRYCOLLECTION (POINT (0 0)").find("expected ')'") != std::string::npos);
  CHECK(wkt_error("CIRCULARSTRING ((0 0").find("is not closed") != std::string::npos);
  CHECK(wkt_error("SRID=x;POINT (0 0)").find("expected ';'") != std::string::npos);
  CHECK(wkt_error(std::string(1'000'000, 'A')).find("unknown word") != std::string::npos);
  CHECK(wkt_error("\xFF\xFE").find("unknown geometry: \"?\"") != std::string::npos);
}

TEST_CASE("a number of too many digits rejects its geometry") {
  CHECK(listed("LINESTRING (0 0, 1 " + std::string(15'000, '7') + ")\nLINESTRING (0 0, 1 1)")
            .starts_with("0 0, 1 1 | a.wkt:2:1 LineString\nrejected:\na.wkt:1:1 LineString: number "
                         "of more than 10000 digits"));
  CHECK(listed("LINESTRING (0 0, 1 " + std::string(1'000'000, '7') + ")")
            .find("number of more than 10000 digits") != std::string::npos);
}

TEST_CASE("collections nest to any depth") {
  std::string text;
  constexpr std::size_t kDepth = 100'000;
  for (std::size_t i = 0; i < kDepth; ++i) text += "GEOMETRYCOLLECTION(";
  text += "LINESTRING(0 0,1 1)" + std::string(kDepth, ')');
  CHECK(evaluate(read_wkt(text, "a")).segments.size() == 1);
}

TEST_CASE("OGC SFA 1.2.1, 8.2: both orders of bytes, as bytes and as hexadecimal digits") {
  for (const bool is_little_endian : {false, true}) {
    const Wkb line = Wkb(is_little_endian).geometry(2).number(2).point(0.5, 1).point(-2, 0.1);
    const auto set = evaluate(read_wkb(line.bytes + line.bytes, "a.wkb"));
    REQUIRE(set.segments.size() == 2);
    CHECK(set.segments[0].a.x == plumbline::Rational(1, 2));
    CHECK(set.segments[1].b.y == plumbline::rational_from(0.1));
    CHECK(set.sources[1].id == "2");
    const auto same = evaluate(read_wkb(hex(line.bytes) + "\n" + hex(line.bytes), "a.wkb"));
    REQUIRE(same.segments == set.segments);
    CHECK(same.sources[1].line == 2);
  }
}

TEST_CASE("each line and each polygon of a geometry of several has a source of its own") {
  CHECK(listed("MULTILINESTRING ((0 0, 1 1), EMPTY, (2 2, 3 3, 4 4))\nLINESTRING (5 5, 6 6)") ==
        "0 0, 1 1 | a.wkt:1:1 MultiLineString #1\n"
        "2 2, 3 3 | a.wkt:1:1 MultiLineString #2\n"
        "3 3, 4 4 | a.wkt:1:1 MultiLineString #2\n"
        "5 5, 6 6 | a.wkt:2:1 LineString\n");
  const auto polygons =
      evaluate(read_wkt("MULTIPOLYGON (((0 0, 9 0, 0 9, 0 0), (1 1, 2 1, 1 2, 1 1)), "
                        "((9 9, 8 9, 9 8, 9 9)))",
                        "a.wkt"));
  REQUIRE(polygons.sources.size() == 2);
  CHECK(polygons.segment_source[5] == plumbline::SourceId(0));  // of the hole
  CHECK(polygons.segment_source[6] == plumbline::SourceId(1));
  // Numbers count through a collection, drawn or not, in whatever tables its parts are.
  CHECK(listed("GEOMETRYCOLLECTION (LINESTRING (0 0, 1 1), POLYGON ((5 0, 6 0, 5 1, 5 0)), "
               "LINESTRING (7 7), LINESTRING (2 2, 3 3))") ==
        "0 0, 1 1 | a.wkt:1:1 LineString #1\n"
        "2 2, 3 3 | a.wkt:1:1 LineString #4\n"
        "5 0, 6 0 | a.wkt:1:1 Polygon #2\n"
        "6 0, 5 1 | a.wkt:1:1 Polygon #2\n"
        "5 1, 5 0 | a.wkt:1:1 Polygon #2\n"
        "rejected:\n"
        "a.wkt:1:1 LineString: line of a single point: 1 line\n");
}

TEST_CASE("the SRID of the geometries is kept; one that differs is listed") {
  CHECK(read_wkt("SRID=03857;LINESTRING (0 0, 1 1)\nLINESTRING (1 1, 2 2)", "a").crs ==
        "EPSG:3857");
  CHECK(read_wkt("SRID=0;LINESTRING (0 0, 1 1)", "a").crs.empty());
  const auto two = read_wkt("SRID=1;LINESTRING (0 0, 1 1)\n SRID=2;LINESTRING (1 1, 2 2)", "a");
  CHECK(two.crs == "EPSG:1");
  CHECK(listing(two) ==
        "0 0, 1 1 | a:1:1 LineString\n1 1, 2 2 | a:2:2 LineString\nremarks:\n"
        "a:2:7 SRID: another reference system than EPSG:1; it is drawn as it is: EPSG:2\n");
  const Wkb line = Wkb().geometry(0x20000002U).number(25832).number(2).point(0, 0).point(1, 1);
  CHECK(read_wkb(line.bytes, "a").crs == "EPSG:25832");
  CHECK(evaluate(read_wkb(hex(line.bytes), "a")).crs == "EPSG:25832");
}

TEST_CASE("WKB: parts are geometries of their own, Z and M and SRID are passed over") {
  const Wkb lines = Wkb()
                        .geometry(5)
                        .number(2)
                        .geometry(2)
                        .number(2)
                        .point(0, 0)
                        .point(1, 1)
                        .geometry(2)
                        .number(2)
                        .point(2, 2)
                        .point(3, 3);
  CHECK(listed_wkb(hex(lines.bytes)) ==
        "0 0, 1 1 | a.wkb:1:1 MultiLineString #1\n2 2, 3 3 | a.wkb:1:1 MultiLineString #2\n");
  const Wkb collection = Wkb()
                             .geometry(7)
                             .number(2)
                             .geometry(1)
                             .point(9, 9)
                             .geometry(6)
                             .number(1)
                             .geometry(3)
                             .number(1)
                             .number(4)
                             .point(0, 0)
                             .point(1, 0)
                             .point(1, 1)
                             .point(0, 0);
  CHECK(listed_wkb(collection.bytes) ==
        "0 0, 1 0 | a.wkb MultiPolygon #1\n1 0, 1 1 | a.wkb MultiPolygon #1\n"
        "1 1, 0 0 | a.wkb MultiPolygon #1\nrejected:\n"
        "a.wkb Point: isolated points are not drawn: 1 point\n");
  const std::string noted =
      "0 5, 1 6 | a.wkb LineString #1\nremarks:\n"
      "a.wkb LineString: coordinates beyond x and y are not used: 1 element from here on\n";
  for (const std::uint32_t type : {3002U, 0xC0000002U}) {  // ISO's ZM and EWKB's
    CHECK(
        listed_wkb(
            Wkb().geometry(type).number(2).point(0, 5).point(8, 8).point(1, 6).point(8, 8).bytes) ==
        noted);
  }
  CHECK(listed_wkb(
            Wkb().geometry(0x20000002U).number(4326).number(2).point(0, 5).point(1, 6).bytes) ==
        "0 5, 1 6 | a.wkb LineString #1\n");
}

TEST_CASE("WKB: coordinates that are not finite reject their geometry") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(listed_wkb(Wkb()
                       .geometry(2)
                       .number(2)
                       .point(0, nan)
                       .point(1, 1)
                       .geometry(2)
                       .number(2)
                       .point(0, 0)
                       .point(1, infinity)
                       .geometry(1)
                       .point(nan, nan)
                       .bytes) ==
        "rejected:\n"
        "a.wkb LineString: coordinate is not a finite number\n"
        "a.wkb LineString: coordinate is not a finite number\n"
        "a.wkb Point: isolated points are not drawn: 0 points\n");
}

TEST_CASE(
    "bytes that are not WKB are refused, and a count of points that are not there costs nothing") {
  CHECK(wkb_error("").find("accepted") != std::string::npos);
  CHECK(wkb_error(std::string("\1", 1)) == "a: not WKB: it ends within a geometry, before byte 2");
  CHECK(wkb_error(Wkb().geometry(2).number(0xFFFFFFFFU).point(0, 0).bytes).find("it ends") !=
        std::string::npos);
  CHECK(wkb_error(Wkb().geometry(99).bytes).find("unknown type 99") != std::string::npos);
  CHECK(wkb_error(Wkb().geometry(4001).bytes).find("unknown type 4001") != std::string::npos);
  CHECK(wkb_error(std::string("\0\0\0\0\2\0\0\0\0\7", 10)) ==
        "a: not WKB: byte order 7, before byte 11");
  CHECK(wkb_error(Wkb().geometry(4).number(1).geometry(2).number(0).bytes)
            .find("LineString where a Point was expected") != std::string::npos);
  CHECK(wkb_error("01020000000") == "a:1:12: not WKB: expected a hexadecimal digit");
  CHECK(wkb_error("POINT (0 0)") ==
        "a:1:1: not WKB: expected a hexadecimal digit: \"POINT (0 0)\"");
}

TEST_CASE("WKB: collections nest to any depth") {
  Wkb wkb;
  for (int i = 0; i < 100'000; ++i) wkb.geometry(7).number(1);
  wkb.geometry(2).number(2).point(0, 0).point(1, 1);
  CHECK(listed_wkb(wkb.bytes) == "0 0, 1 1 | a.wkb LineString #1\n");
}

// Path data and lists of points, through read_svg. The cases follow the grammar of SVG 1.1, 8.3.9
// and 9.7.1.

#include <catch2/catch.hpp>

#include "plumbline/read.hpp"
#include "support/listing.hpp"

using plumbline::evaluate;
using plumbline::read_svg;

namespace {

plumbline::SegmentSet drawn(const std::string& element) {
  return evaluate(read_svg("<svg>" + element + "</svg>", "a.svg"));
}

/// The segments of a path, joined by "; ", then what was rejected.
std::string path(const std::string& data) {
  const auto set = drawn("<path d=\"" + data + "\"/>");
  std::string text;
  for (const auto& segment : set.segments) {
    text += (text.empty() ? "" : "; ") + to_text(segment);
  }
  for (const auto& item : set.rejected) text += " [" + item.reason + ": " + item.text + "]";
  return text;
}

std::string points(const std::string& element, const std::string& list) {
  const auto set = drawn("<" + element + " points=\"" + list + "\"/>");
  std::string text;
  for (const auto& segment : set.segments) {
    text += (text.empty() ? "" : "; ") + to_text(segment);
  }
  for (const auto& item : set.rejected) text += " [" + item.reason + ": " + item.text + "]";
  return text;
}

}  // namespace

TEST_CASE("the straight commands draw, absolute and relative") {
  const auto [data, drawing] = GENERATE(table<std::string, std::string>({
      {"M 1 2 L 3 4", "1 2, 3 4"},
      {"M1 2L3 4", "1 2, 3 4"},
      {"m 1 2 l 3 4", "1 2, 4 6"},
      {"M 1 2 H 5 h -1", "1 2, 5 2; 5 2, 4 2"},
      {"M 1 2 V 5 v -1", "1 2, 1 5; 1 5, 1 4"},
      {"M 0 0 L 1 0 1 1 0 1", "0 0, 1 0; 1 0, 1 1; 1 1, 0 1"},
      {"M 0 0 1 0 1 1", "0 0, 1 0; 1 0, 1 1"},
      {"m 5 5 1 0 0 1", "5 5, 6 5; 6 5, 6 6"},
      {"M 0 0 H 1 2 3", "0 0, 1 0; 1 0, 2 0; 2 0, 3 0"},
      {"M 0 0 v 1 1", "0 0, 0 1; 0 1, 0 2"},
      {"M 0 0 L 1 0 M 5 5 l 1 0", "0 0, 1 0; 5 5, 6 5"},
      {"M 0 0 l 1 0 m 5 5 l 1 0", "0 0, 1 0; 6 5, 7 5"},
  }));
  CAPTURE(data);
  CHECK(path(data) == drawing);
}

TEST_CASE("numbers need no separators where none is ambiguous") {
  const auto [data, drawing] = GENERATE(table<std::string, std::string>({
      {"M 0.6.5L1-2", "0.6 0.5, 1 -2"},
      {"M.5.5.5.7", "0.5 0.5, 0.5 0.7"},
      {"M-1-2-3-4", "-1 -2, -3 -4"},
      {"M5.,5.L+3+.4", "5 5, 3 0.4"},
      {"M1e3,1E-2L1e+1-1e1", "1000 0.01, 10 -10"},
      {"M\t1 \n,\r2 , 3,4", "1 2, 3 4"},
      {"  M1 2 3 4  ", "1 2, 3 4"},
      {"M9007199254740993 0.1L0 0", "9007199254740993 0.1, 0 0"},
  }));
  CAPTURE(data);
  CHECK(path(data) == drawing);
}

TEST_CASE("closing draws to the subpath's start, and the next command goes on from there") {
  CHECK(path("M 1 1 H 2 V 2 Z") == "1 1, 2 1; 2 1, 2 2; 2 2, 1 1");
  CHECK(path("M 1 1 H 2 V 2 z l 5 0") == "1 1, 2 1; 2 1, 2 2; 2 2, 1 1; 1 1, 6 1");
  CHECK(path("M 1 1 H 2 V 2 z m 1 1 h 1") == "1 1, 2 1; 2 1, 2 2; 2 2, 1 1; 2 2, 3 2");
  CHECK(path("M 1 1 H 2 z h 3 z") == "1 1, 2 1; 2 1, 1 1; 1 1, 4 1; 4 1, 1 1");
}

TEST_CASE("closing at the subpath's start draws nothing") {
  CHECK(path("M 0 0 H 1 V 1 L 0 0 Z") == "0 0, 1 0; 1 0, 1 1; 1 1, 0 0");
  CHECK(path("M 0 0 H 1 H 0 Z z") == "0 0, 1 0; 1 0, 0 0");
  // In doubles 0.1 + 0.2 - 0.3 is not 0.
  CHECK(path("M 0 0 h .1 v 1 h .2 v -1 h -.3 z") ==
        "0 0, 0.1 0; 0.1 0, 0.1 1; 0.1 1, 0.3 1; 0.3 1, 0.3 0; 0.3 0, 0 0");
}

TEST_CASE("after a curve the path goes on from its end") {
  const auto set = drawn("<path d='M1 1 c0 4 3 5 5 6 h1'/>");
  CHECK(to_text(set.segments[set.segments.size() - 1]) == "6 7, 7 7");
  CHECK(path("M0 0 a1 1 0 01.5.5 h1").ends_with("0.5 0.5; 0.5 0.5, 1.5 0.5"));
}

TEST_CASE("an arc without a radius is a straight line, one without length is left out") {
  CHECK(path("M0 0A0 5 30 0 1 3 4") == "0 0, 3 4");
  CHECK(path("M1 1a5 0 30 0 1 3 4") == "1 1, 4 5");
  CHECK(path("M1 1 A5 6 0 1 1 1 1 h1") == "1 1, 2 1");
}

TEST_CASE("an error ends the path: what came before is kept, the rest is rejected") {
  const auto [data, drawing] = GENERATE(table<std::string, std::string>({
      {"M 0 0 H 1 L 2", "0 0, 1 0 [malformed path data at character 14: L 2]"},
      {"M 0 0 H 1 L 2 2 3 L 4 4",
       "0 0, 1 0; 1 0, 2 2 [malformed path data at character 19: 3 L 4 4]"},
      {"M 0 0 H 1 X 5", "0 0, 1 0 [malformed path data at character 11: X 5]"},
      {"M 0 0 H 1, V 2", "0 0, 1 0 [malformed path data at character 12: , V 2]"},
      {"M 0 0 H 1,,2", "0 0, 1 0 [malformed path data at character 11: ,,2]"},
      {"M, 0 0 H 1", " [malformed path data at character 2: M, 0 0 H 1]"},
      {"M 0 0 H 1 Z 5", "0 0, 1 0; 1 0, 0 0 [malformed path data at character 13: 5]"},
      {"L 1 1 2 2", " [path data without a moveto at its beginning at character 1: L 1 1 2 2]"},
      {"M 0 0 A 1 1 0 2 1 3 3", " [malformed path data at character 15: A 1 1 0 2 1 3 3]"},
      {"M 0 0 H 1e99999 V 1", " [decimal exponent beyond 10000 at character 9: H 1e99999 V 1]"},
      {"none", " [draws nothing: d=\"none\"]"},  // SVG 2
  }));
  CAPTURE(data);
  CHECK(path(data) == drawing);
}

TEST_CASE("a path that draws nothing is rejected, a zero-length piece is rejected alone") {
  CHECK(path("") == " [draws nothing: d=\"\"]");
  CHECK(path("M 1 2") == " [draws nothing: d=\"M 1 2\"]");
  CHECK(path("M 1 2 z") == " [draws nothing: d=\"M 1 2 z\"]");
  CHECK(path("M 1 2 h 0 h 1") == "1 2, 2 2 [zero-length segment: 1 2, 1 2]");
}

TEST_CASE("a polyline joins its points, a polygon closes them") {
  CHECK(points("polyline", "0,0 1,0 1,1") == "0 0, 1 0; 1 0, 1 1");
  CHECK(points("polygon", "0,0 1,0 1,1") == "0 0, 1 0; 1 0, 1 1; 1 1, 0 0");
  CHECK(points("polygon", "0 0 1 0 1 1 0 0") == "0 0, 1 0; 1 0, 1 1; 1 1, 0 0");
  CHECK(points("polygon", "0 0 1 0") == "0 0, 1 0; 1 0, 0 0");
  CHECK(points("polyline", "1-2 .5.5,\n3 , 4 ") == "1 -2, 0.5 0.5; 0.5 0.5, 3 4");
}

TEST_CASE("an error in a list of points ends it, unclosed") {
  CHECK(points("polygon", "0 0 1 0 1 1 5") ==
        "0 0, 1 0; 1 0, 1 1 [malformed list of points at character 14:  5]");
  CHECK(points("polyline", "0 0,1 0,") == "0 0, 1 0 [malformed list of points at character 9: ,]");
  CHECK(points("polyline", "0 0 1 0 x 3") ==
        "0 0, 1 0 [malformed list of points at character 9:  x 3]");
  CHECK(points("polyline", "0 0;1 0") == " [malformed list of points at character 4: ;1 0]");
  CHECK(points("polyline", "") == " [draws nothing: points=\"\"]");
  CHECK(points("polygon", "3 4") == " [draws nothing: points=\"3 4\"]");
}

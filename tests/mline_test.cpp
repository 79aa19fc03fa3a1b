// Multilines and boundaries of hatches.

#include <catch2/catch.hpp>

#include "plumbline/read.hpp"
#include "support/dxf_text.hpp"
#include "support/listing.hpp"

namespace {

using plumbline::dxf_lines;
using plumbline::dxf_with;
using plumbline::ReadOptions;

/// A drawing with this entity.
std::string with_entity(std::string entity) {
  while (entity.ends_with(' ')) entity.pop_back();
  return dxf_with(entity);
}

/// A vertex of an MLINE at (x, y) with its direction and miter, and two lines 1 to the left and to
/// the right with these parameters behind their first.
std::string vertex(const std::string& xy, const std::string& direction, const std::string& miter,
                   const std::string& left = "74 2 41 1 41 0 75 0 ",
                   const std::string& right = "74 2 41 -1 41 0 75 0 ") {
  return xy + " " + direction + " " + miter + " " + left + right;
}

const std::string kEast = "12 1 22 0", kNorthMiter = "13 0 23 1";

std::string style(const std::string& flags) {
  return dxf_lines("0 SECTION 2 OBJECTS 0 MLINESTYLE 2 Wall 70 " + flags + " 71 2 0 ENDSEC 0 EOF");
}

/// An MLINE of this style between (0, 0) and (4, 0).
std::string straight(const std::string& flags, const std::string& first_left,
                     const std::string& style_flags) {
  const std::string entity = "0 SECTION 2 ENTITIES 0 MLINE 8 W 2 WALL 40 2 70 0 71 " + flags +
                             " 72 2 73 2 10 0 20 0 " +
                             vertex("11 0 21 0", kEast, kNorthMiter, first_left) +
                             vertex("11 4 21 0", kEast, kNorthMiter) + "0 ENDSEC";
  return dxf_lines(entity) + style(style_flags);
}

std::string segments(const std::string& text, const ReadOptions& options = {}) {
  return segments_of(evaluate(plumbline::read_dxf(text, "a.dxf", options)));
}

const std::string kWhole = "74 2 41 1 41 0 75 0 ";

}  // namespace

TEST_CASE("the lines of an MLINE are where its parameters have them, with their breaks") {
  CHECK(segments(straight("1", kWhole, "0")) == "0 1, 4 1\n0 -1, 4 -1\n");
  CHECK(segments(straight("1", "74 4 41 1 41 0 41 1.5 41 2.25 75 0 ", "0")) ==
        "0 1, 1.5 1\n2.25 1, 4 1\n0 -1, 4 -1\n");
  CHECK(segments(straight("1", "74 3 41 1 41 0.5 41 3 75 0 ", "0")) == "0.5 1, 3 1\n0 -1, 4 -1\n");
  CHECK(segments(straight("1", "74 1 41 1 75 0 ", "0")) == "0 1, 4 1\n0 -1, 4 -1\n");
}

TEST_CASE("a closed MLINE goes back to its first vertex; each of its lines is a ring") {
  const std::string north = "12 0 22 1";
  const auto set = evaluate(plumbline::read_dxf(
      with_entity("0 MLINE 8 W 2 WALL 71 3 72 3 73 2 " + vertex("11 0 21 0", kEast, "13 1 23 1") +
                  vertex("11 9 21 0", north, "13 -1 23 1") +
                  vertex("11 9 21 9", "12 -1 22 0", "13 -1 23 -1") +
                  vertex("11 0 21 9", "12 0 22 -1", "13 1 23 -1")),
      "a.dxf"));
  CHECK(segments_of(set) ==
        "1 1, 8 1\n8 1, 8 8\n8 8, 1 8\n1 8, 1 1\n"
        "-1 -1, 10 -1\n10 -1, 10 10\n10 10, -1 10\n-1 10, -1 -1\n");
  CHECK(set.rings.size() == 2);
}

TEST_CASE("the style of an MLINE, found behind it, draws caps and joints") {
  CHECK(segments(straight("1", kWhole, "272")) == "0 1, 4 1\n0 -1, 4 -1\n0 -1, 0 1\n4 -1, 4 1\n");
  CHECK(segments(straight("5", kWhole, "272")) == "0 1, 4 1\n0 -1, 4 -1\n4 -1, 4 1\n");
  CHECK(segments(straight("9", kWhole, "272")) == "0 1, 4 1\n0 -1, 4 -1\n0 -1, 0 1\n");
  CHECK(segments(straight("1", kWhole, "2")) == "0 1, 4 1\n0 -1, 4 -1\n");
  const std::string bent = with_entity(
      "0 MLINE 8 W 2 wall 71 1 72 3 73 2 " + vertex("11 0 21 0", kEast, kNorthMiter) +
      vertex("11 5 21 0", kEast, kNorthMiter) + vertex("11 9 21 0", kEast, kNorthMiter));
  CHECK(segments(bent.substr(0, bent.rfind("0\nEOF")) + style("2")) ==
        "0 1, 5 1\n5 1, 9 1\n0 -1, 5 -1\n5 -1, 9 -1\n5 -1, 5 1\n");
}

TEST_CASE("round caps of an MLINE are half circles away from it") {
  ReadOptions options;
  options.chord_tolerance = 10;
  const std::string text = segments(straight("1", kWhole, "1088"), options);
  CHECK(text.find("-1 0") != text.npos);
  CHECK(text.find("5 0") != text.npos);
  CHECK(text.find("1 0,") == text.find("-1 0,") + 1);
}

TEST_CASE("an MLINE without parameters is lost, one without length is not") {
  const auto rejected = [](const std::string& entity) {
    return rejected_of(evaluate(plumbline::read_dxf(dxf_with(entity), "a.dxf")));
  };
  CHECK(rejected("0 MLINE 8 W 2 S 11 0 21 0 74 0 75 0 11 1 21 0 74 0 75 0") ==
        "a.dxf:6 MLINE (W): multiline without parameters for all of its lines\n");
  CHECK(rejected("0 MLINE 8 W 2 S 11 0 21 0 74 1 41 0") ==
        "a.dxf:6 MLINE (W): multiline of fewer than two vertices\n");
}

TEST_CASE("hatches are listed once, or their boundaries drawn on a layer of their own") {
  const std::string hatches =
      "0 HATCH 8 A 10 0 20 0 91 1 92 2 72 0 73 1 93 3 10 0 20 0 10 1 20 0 10 0 20 1 97 0 75 0 98 1 "
      "10 9 20 9 0 HATCH 8 A 91 1 92 1 93 2 72 1 10 5 20 5 11 6 21 5 72 1 10 6 20 5 11 5 21 6 97 1 "
      "330 F 75 0";
  CHECK(rejected_of(evaluate(plumbline::read_dxf(dxf_with(hatches), "a.dxf"))) ==
        "a.dxf:6 HATCH (A): fills, pictures and masks are not read (2 of them)\n");
  ReadOptions options;
  options.hatches = true;
  const auto set = evaluate(plumbline::read_dxf(dxf_with(hatches), "a.dxf", options));
  CHECK(segments_of(set) == "0 0, 1 0\n1 0, 0 1\n0 1, 0 0\n5 5, 6 5\n6 5, 5 6\n");
  CHECK(set.rejected.empty());
  CHECK(set.sources.at(0).layer == "A HATCH");
  CHECK(set.sources.at(0).element == "HATCH");
  options.layers = {"*hatch"};
  CHECK(segments(dxf_with("0 LINE 8 A 10 0 20 0 11 1 21 1 " + hatches), options) ==
        segments_of(set));
  options.layers = {"A"};
  CHECK(segments(dxf_with("0 LINE 8 A 10 0 20 0 11 1 21 1 " + hatches), options) == "0 0, 1 1\n");
}

TEST_CASE("edges of a hatch are lines, arcs either way, ellipses and splines; OCS is mirrored") {
  ReadOptions options;
  options.hatches = true;
  options.chord_tolerance = 10;
  const auto ends = [&](const std::string& edge, const std::string& more = {}) {
    const auto set = evaluate(plumbline::read_dxf(
        dxf_with("0 HATCH 8 A 91 1 92 1 93 1 " + edge + " 97 0 75 0" + more), "a.dxf", options));
    REQUIRE(!set.segments.empty());
    return to_text(set.segments[0].a) + ", " + to_text(set.segments[set.segments.size() - 1].b);
  };
  CHECK(ends("72 2 10 0 20 0 40 2 50 0 51 90 73 1") == "2 0, 0 2");
  // Clockwise angles are those of the mirror image: from 270 to 360 is what lies between 0 and 90.
  CHECK(ends("72 2 10 0 20 0 40 2 50 270 51 360 73 0") == "2 0, 0 2");
  CHECK(ends("72 3 10 1 20 0 11 4 21 0 40 0.5 50 90 51 180 73 1") == "1 2, -3 0");
  CHECK(ends("72 4 94 2 73 0 74 0 95 6 96 3 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 1 20 1 10 2 "
             "20 0") == "0 0, 2 0");
  CHECK(ends("72 1 10 5 20 5 11 6 21 7", " 210 0 220 0 230 -1") == "-5 5, -6 7");
  CHECK(ends("72 2 10 0 20 0 40 2 50 0 51 90 73 1", " 210 0 220 0 230 -1") == "-2 0, 0 2");
  CHECK(rejected_of(evaluate(plumbline::read_dxf(
            dxf_with("0 HATCH 8 A 91 1 92 1 93 1 72 7 10 0 97 0 75 0"), "a.dxf", options))) ==
        "a.dxf:6 HATCH (A HATCH): an edge of its boundary: not understood: group 72: 7\n");
}

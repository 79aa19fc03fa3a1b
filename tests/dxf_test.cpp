#include <catch2/catch.hpp>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "support/dxf_text.hpp"
#include "support/listing.hpp"

using plumbline::dxf_lines;
using plumbline::dxf_with;
using plumbline::evaluate;
using plumbline::read_dxf;

namespace {

std::string listing_of(const std::string& text, const plumbline::ReadOptions& options = {}) {
  return listing(read_dxf(text, "a.dxf", options));
}

/// The segments alone.
std::string drawn(const std::string& text) {
  return segments_of(evaluate(read_dxf(text, "a.dxf")));
}

std::string rejected(const std::string& text) {
  return rejected_of(evaluate(read_dxf(text, "a.dxf")));
}

std::string error_of(const std::string& text) {
  try {
    read_dxf(text, "a.dxf");
  } catch (const plumbline::Error& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("a LINE is exact, with its line in the file, handle and layer") {
  CHECK(listing_of(dxf_with("0 LINE 5 2F 8 WALLS 10 0.1 20 -1e2 30 0.0 11 .5 21 1. 31 0")) ==
        "0.1 -100, 0.5 1 | a.dxf:6 LINE #2F (WALLS)\n");
  CHECK(drawn(dxf_with("0 LINE 8 0 10 0.123456789012345678901234567890 20 9007199254740993 "
                       "11 0 21 0")) == "0.12345678901234567890123456789 9007199254740993, 0 0\n");
}

TEST_CASE("line ends and blanks around codes and values make no difference") {
  const std::string text = dxf_with("0 LINE 8 A 10 1 20 2 11 3 21 4 999 a_comment");
  std::string blanks = "\xEF\xBB\xBF";
  std::string old_mac;
  for (const char c : text) {
    blanks += c == '\n' ? "  \r\n  " : std::string(1, c);
    old_mac += c == '\n' ? '\r' : c;
  }
  const std::string expected = "1 2, 3 4 | a.dxf:6 LINE (A)\n";
  CHECK(listing_of(text) == expected);
  CHECK(listing_of(blanks) == expected);
  CHECK(listing_of(old_mac) == expected);
  CHECK(listing_of(text + "trash after the end") == expected);
}

TEST_CASE("entities of one layer are one Struct, in the order in which layers occur") {
  const plumbline::Structure structure =
      read_dxf(dxf_with("0 LINE 8 B 10 0 20 0 11 1 21 0 0 LINE 8 A 10 0 20 1 11 1 21 1 "
                        "0 LINE 8 B 10 0 20 2 11 1 21 2"),
               "a.dxf");
  CHECK(listing(structure) ==
        "0 0, 1 0 | a.dxf:6 LINE (B)\n"
        "0 2, 1 2 | a.dxf:30 LINE (B)\n"
        "0 1, 1 1 | a.dxf:18 LINE (A)\n");
  REQUIRE(structure.structs.size() == 3);
  CHECK(structure.structs[1].name == "B");
  CHECK(structure.structs[1].category == "layer");
  CHECK(structure.y_up);
}

TEST_CASE("a closed polyline ends exactly where it starts") {
  const std::string corners = "10 0 20 0 10 2.5 20 0 10 2.5 20 1";
  CHECK(drawn(dxf_with("0 LWPOLYLINE 8 0 90 3 70 1 " + corners)) ==
        "0 0, 2.5 0\n2.5 0, 2.5 1\n2.5 1, 0 0\n");
  CHECK(drawn(dxf_with("0 LWPOLYLINE 8 0 90 3 70 0 " + corners)) == "0 0, 2.5 0\n2.5 0, 2.5 1\n");
  // Bit 128 is about line types; the last vertex may be the first again.
  CHECK(drawn(dxf_with("0 LWPOLYLINE 8 0 90 3 70 129 10 0 20 0 10 1 20 0 10 0.0 20 0e3")) ==
        "0 0, 1 0\n1 0, 0 0\n");
}

TEST_CASE("a POLYLINE takes its vertices up to SEQEND") {
  const std::string vertices =
      "0 VERTEX 8 0 10 0 20 0 0 VERTEX 8 0 10 1 20 0 0 VERTEX 8 0 10 1 20 1 0 SEQEND 8 0 ";
  CHECK(listing_of(dxf_with("0 POLYLINE 8 P 66 1 70 1 10 0 20 0 " + vertices +
                            "0 LINE 8 P 10 5 20 5 11 6 21 6")) ==
        "0 0, 1 0 | a.dxf:6 POLYLINE (P)\n"
        "1 0, 1 1 | a.dxf:6 POLYLINE (P)\n"
        "1 1, 0 0 | a.dxf:6 POLYLINE (P)\n"
        "5 5, 6 6 | a.dxf:46 LINE (P)\n");
  CHECK(rejected(dxf_with("0 POLYLINE 8 P 0 VERTEX 10 0 20 0 0 VERTEX 10 x 20 0 0 VERTEX 10 1 20 0 "
                          "0 SEQEND")) ==
        "a.dxf:6 POLYLINE (P): its VERTEX in line 16: not a number: group 10: x\n");
  CHECK(rejected(dxf_with("0 POLYLINE 8 P 0 SEQEND 0 VERTEX 10 1 20 1")) ==
        "a.dxf:6 POLYLINE (P): polyline of fewer than two vertices\n"
        "a.dxf:12 VERTEX (0): without a POLYLINE\n");
}

TEST_CASE("the control frame of a fitted polyline is listed, not drawn") {
  CHECK(listing_of(dxf_with("0 POLYLINE 8 P 70 4 0 VERTEX 10 0 20 0 70 16 0 VERTEX 10 0 20 0 70 8 "
                            "0 VERTEX 10 1 20 1 70 8 0 VERTEX 10 2 20 9 70 16 0 SEQEND")) ==
        "0 0, 1 1 | a.dxf:6 POLYLINE (P)\n"
        "rejected:\n"
        "a.dxf:6 POLYLINE (P): vertex of the frame of a fitted curve (2 of them)\n");
}

TEST_CASE("meshes are grids, polyface meshes are the outlines of their faces") {
  const std::string four =
      "0 VERTEX 10 0 20 0 70 64 0 VERTEX 10 1 20 0 70 64 "
      "0 VERTEX 10 0 20 1 70 64 0 VERTEX 10 1 20 1 70 64 ";
  CHECK(drawn(dxf_with("0 POLYLINE 8 0 70 16 71 2 72 2 " + four + "0 SEQEND")) ==
        "0 0, 1 0\n0 0, 0 1\n1 0, 1 1\n0 1, 1 1\n");
  std::string faces = four;
  for (std::size_t at = 0; (at = faces.find("70 64", at)) != std::string::npos; ++at) {
    faces.replace(at, 5, "70 192");
  }
  faces += "0 VERTEX 70 128 71 1 72 -2 73 4 ";
  plumbline::ReadOptions all;
  all.hidden = true;
  CHECK(listing_of(dxf_with("0 POLYLINE 8 0 70 64 " + faces + "0 SEQEND"), all) ==
        "0 0, 1 0 | a.dxf:6 POLYLINE (0)\n1 0, 1 1 | a.dxf:6 POLYLINE (0)\n"
        "1 1, 0 0 | a.dxf:6 POLYLINE (0)\n");
  CHECK(listing_of(dxf_with("0 POLYLINE 8 0 70 64 " + faces + "0 SEQEND")) ==
        "0 0, 1 0 | a.dxf:6 POLYLINE (0)\n1 1, 0 0 | a.dxf:6 POLYLINE (0)\n"
        "rejected:\na.dxf:6 POLYLINE (0): hidden edge\n");
  CHECK(rejected(dxf_with("0 POLYLINE 8 0 70 64 0 VERTEX 70 128 71 9 72 1 0 SEQEND")) ==
        "a.dxf:6 POLYLINE (0): face with a vertex that is not there: 9\n");
  CHECK(rejected(dxf_with("0 POLYLINE 8 0 70 16 71 3 72 2 " + four + "0 SEQEND")) ==
        "a.dxf:6 POLYLINE (0): mesh of 3 x 2 with 4 vertices\n");
  CHECK(
      rejected(dxf_with("0 POLYLINE 8 0 70 16 71 4 72 9223372036854775807 " + four + "0 SEQEND")) ==
      "a.dxf:6 POLYLINE (0): mesh of 4 x 9223372036854775807 with 4 vertices\n");
}

TEST_CASE("faces and solids are outlines; a solid's corners come in the shape of a Z") {
  const std::string corners = "10 0 20 0 11 1 21 0 12 0 22 1 13 1 23 1";
  CHECK(drawn(dxf_with("0 SOLID 8 0 " + corners)) == "0 0, 1 0\n1 0, 1 1\n1 1, 0 1\n0 1, 0 0\n");
  CHECK(drawn(dxf_with("0 3DFACE 8 0 " + corners)) == "0 0, 1 0\n1 0, 0 1\n0 1, 1 1\n1 1, 0 0\n");
  CHECK(drawn(dxf_with("0 TRACE 8 0 10 0 20 0 11 1 21 0 12 0 22 1 13 0 23 1")) ==
        "0 0, 1 0\n1 0, 0 1\n0 1, 0 0\n");
}

TEST_CASE("an extrusion towards -z mirrors x of what has coordinates of its own") {
  const std::string back = " 210 0 220 0 230 -1";
  CHECK(drawn(dxf_with("0 LWPOLYLINE 8 0 10 1 20 2 10 3 20 4" + back)) == "-1 2, -3 4\n");
  CHECK(drawn(dxf_with("0 LINE 8 0 10 1 20 2 11 3 21 4" + back)) == "1 2, 3 4\n");
  CHECK(rejected(dxf_with("0 LWPOLYLINE 8 0 10 1 20 2 10 3 20 4 210 0 220 0.6 230 0.8")) ==
        "a.dxf:6 LWPOLYLINE (0): not in the plane: extruded in another direction than z: 0 0.6 "
        "0.8\n");
}

TEST_CASE("z is left out and counted") {
  CHECK(
      listing_of(dxf_with("0 LINE 8 A 10 0 20 0 30 1 11 1 21 0 31 1 0 LINE 8 B 10 0 20 1 11 1 21 1 "
                          "31 -2 0 LWPOLYLINE 8 B 38 0.0 10 0 20 5 10 1 20 5")) ==
      "0 0, 1 0 | a.dxf:6 LINE (A)\n"
      "0 1, 1 1 | a.dxf:22 LINE (B)\n"
      "0 5, 1 5 | a.dxf:36 LWPOLYLINE (B)\n"
      "remarks:\n"
      "a.dxf:6 LINE (A): z is left out: drawn as it is seen from above (2 of them)\n");
}

TEST_CASE("what is not drawn is listed by kind, with counts") {
  CHECK(listing_of(dxf_with("0 LEADER 8 N 1 hello 0 POINT 8 0 10 0 20 0 0 LEADER 8 N 1 you "
                            "0 FROBNICATE 8 0 0 LINE 67 1 8 0 10 0 20 0 11 1 21 1 "
                            "0 POLYLINE 67 1 0 VERTEX 67 1 10 0 20 0 0 SEQEND 67 1")) ==
        "rejected:\n"
        "a.dxf:6 LEADER (N): annotation is not read (2 of them)\n"
        "a.dxf:12 POINT (0): points are not read\n"
        "a.dxf:26 FROBNICATE (0): not understood\n"
        "a.dxf:30 LINE (0): in paper space\n"
        "a.dxf:44 POLYLINE (0): in paper space\n");
}

TEST_CASE("what is no line work is harmless; what may be is lost") {
  const auto lost = [](const std::string& entities) {
    return lost_of(evaluate(read_dxf(dxf_with(entities), "a.dxf")));
  };
  CHECK(lost("0 TEXT 0 MTEXT 0 ATTDEF 0 DIMENSION 0 LEADER 0 HATCH 0 IMAGE 0 WIPEOUT 0 POINT "
             "0 VIEWPORT 0 LIGHT 0 CAMERA 0 SUN 0 GEOPOSITIONMARKER 0 LINE 67 1 0 LINE 8 0 10 1 20 "
             "1 11 1 21 1")
            .empty());
  CHECK(lost("0 LINE 8 0 10 1 20 1 11 2 21 2 0 MPOLYGON 0 XLINE 0 3DSOLID 0 REGION 0 "
             "ACAD_PROXY_ENTITY 0 FROBNICATE") ==
        "MPOLYGON XLINE 3DSOLID REGION ACAD_PROXY_ENTITY FROBNICATE ");
  CHECK(lost("0 INSERT 8 0 2 none 0 CIRCLE 8 0 10 0 20 0 40 -1 0 LINE 8 0 10 0 20 0 11 1") ==
        "INSERT CIRCLE LINE ");
}

TEST_CASE("an entity at fault is listed with line, group and text; the others are drawn") {
  CHECK(
      listing_of(dxf_with("0 LINE 8 0 10 1 20 2 11 3 0 LINE 8 0 10 0x1 20 2 11 3 21 4 "
                          "0 LWPOLYLINE 8 0 10 1 10 2 20 3 0 LWPOLYLINE 8 0 70 1.5 10 1 20 1 10 2 "
                          "20 3 0 LINE 8 0 10 0 20 0 11 1 21 1")) ==
      "0 0, 1 1 | a.dxf:52 LINE (0)\n"
      "rejected:\n"
      "a.dxf:6 LINE (0): has no group 21\n"
      "a.dxf:16 LINE (0): not a number: group 10: 0x1\n"
      "a.dxf:28 LWPOLYLINE (0): vertex without group 20\n"
      "a.dxf:38 LWPOLYLINE (0): not an integer: group 70: 1.5\n");
}

TEST_CASE("a file that is no DXF is refused with line and text") {
  CHECK(error_of("") == "a.dxf:1: no section: this is no DXF text");
  CHECK(error_of("<svg/>\n<line/>\n") == "a.dxf:1:1: expected a DXF group code: \"<svg/>\"");
  CHECK(error_of(dxf_lines("0 SECTION 2 ENTITIES 0 LINE 10")) ==
        "a.dxf:7:1: the file ends after a group code: \"10\"");
  CHECK(error_of(dxf_lines("0 SECTION 2 ENTITIES 0 LINE 1O 5")) ==
        "a.dxf:7:1: expected a DXF group code: \"1O\"");
  CHECK(error_of("5\nA\n0\nSECTION\n") == "a.dxf:1:1: a DXF text begins with group code 0, not 5");
}

TEST_CASE("a file that is cut off is read as far as it goes, which is listed") {
  CHECK(listing_of(dxf_lines("0 SECTION 2 ENTITIES 0 LINE 10 0 20 0 11 1 21 1")) ==
        "0 0, 1 1 | a.dxf:6 LINE (0)\n"
        "rejected:\na.dxf:15 EOF: the file ends inside a section\n");
  CHECK(listing_of(dxf_lines("0 SECTION 2 ENTITIES 0 LINE 10 0 20 0 11 1 21 1 0 ENDSEC")) ==
        "0 0, 1 1 | a.dxf:6 LINE (0)\n"
        "remarks:\na.dxf:17 EOF: the file ends without EOF\n");
}

TEST_CASE("data of applications and embedded objects are not taken for the entity's own") {
  CHECK(drawn(dxf_with("0 LINE 8 0 102 {ACAD 10 7 102 } 10 0 20 0 11 1 21 1 1001 X 1010 9")) ==
        "0 0, 1 1\n");
  CHECK(drawn(dxf_with("0 LWPOLYLINE 8 0 10 0 20 0 10 1 20 1 101 Embedded 10 5 20 5")) ==
        "0 0, 1 1\n");
}

TEST_CASE("layers that are off, frozen or not printed and invisible entities are left out") {
  const std::string text = dxf_with(
      "0 LINE 8 off 10 0 20 0 11 1 21 0 0 LINE 8 FROZEN 10 0 20 1 11 1 21 1 "
      "0 LINE 8 Shown 10 0 20 2 11 1 21 2 0 LINE 8 Shown 60 1 10 0 20 3 11 1 21 3 "
      "0 LINE 8 Aid 10 0 20 4 11 1 21 4 0 CIRCLE 8 Off 0 TEXT 8 off 1 x 0 LINE 8 defpoints 10 0",
      "0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 Off 62 -7 70 0 0 LAYER 2 Frozen 70 1 "
      "62 7 0 LAYER 2 Shown 62 5 70 4 0 LAYER 2 Aid 420 66051 290 0 0 LAYER 2 Defpoints 62 20 "
      "0 ENDTAB 0 ENDSEC");
  CHECK(listing_of(text) ==
        "0 2, 1 2 | a.dxf:80 LINE (Shown)\n"
        "rejected:\n"
        "a.dxf:56 LAYER (Off): what is on layer Off, which is off (3 of them)\n"
        "a.dxf:68 LAYER (Frozen): what is on layer Frozen, which is frozen\n"
        "a.dxf:92 LINE (Shown): hidden: marked as invisible\n"
        "a.dxf:106 LAYER (Aid): what is on layer Aid, which is not plotted\n"
        "a.dxf:128 LAYER (Defpoints): what is on layer Defpoints, which is not plotted\n");
  plumbline::ReadOptions all;
  all.hidden = true;
  CHECK(segments_of(evaluate(read_dxf(text, "a.dxf", all))) ==
        "0 0, 1 0\n0 1, 1 1\n0 2, 1 2\n0 3, 1 3\n0 4, 1 4\n");
  CHECK(
      layers_of(evaluate(read_dxf(text, "a.dxf"))) ==
      "Off - hidden\nFrozen - hidden\nShown 0000ff\nAid 010203 hidden\nDefpoints ff3f00 hidden\n");
}

TEST_CASE("names become UTF-8 by the code page, or as they are from AC1021 on") {
  const auto layer = [](const std::string& version, const std::string& page,
                        const std::string& name) {
    const std::string text = dxf_with(
        "0 LINE 8 " + name + " 10 0 20 0 11 1 21 1",
        "0 SECTION 2 HEADER 9 $ACADVER 1 " + version + " 9 $DWGCODEPAGE 3 " + page + " 0 ENDSEC");
    return evaluate(read_dxf(text, "a.dxf")).sources.at(0).path;
  };
  CHECK(layer("AC1015", "ANSI_1252", "W\xE4nde") == "W\xC3\xA4nde");
  CHECK(layer("AC1009", "dos850", "W\x84nde") == "W\xC3\xA4nde");
  CHECK(layer("AC1015", "ANSI_1251", "\xCF") == "\xD0\x9F");
  CHECK(layer("AC1032", "ANSI_1252", "W\xC3\xA4nde") == "W\xC3\xA4nde");
  CHECK(layer("AC1032", "ANSI_1252", "W\xE4nde") == "W\xC3\xA4nde");
  CHECK(layer("AC1015", "//IGNORE", "W\xE4nde") == "W\xC3\xA4nde");
  CHECK(layer("AC1015", "ANSI_1252", "\\U+00E4\\U+12\\x\\U+D800") == "\xC3\xA4\\U+12\\x\\U+D800");
}

TEST_CASE("the example plan is read whole: doors turned and mirrored, loops closed") {
  const auto structure = plumbline::read(PLUMBLINE_EXAMPLES "/flat.dxf");
  const plumbline::SegmentSet set = evaluate(structure);
  CHECK(rejected_of(set).find("LAYER (GRID): what is on layer GRID, which is frozen") !=
        std::string::npos);
  CHECK(set.rejected.size() == 1);
  const std::string segments = segments_of(set);
  CHECK(segments.find("6 3.2, 5.1 3.2\n") != segments.npos);  // the leaf of the turned door
  CHECK(segments.find("2.9 4, 2.9 4.9\n") != segments.npos);  // and of the mirrored one
  for (const plumbline::Struct& s : structure.structs) {
    for (const auto& item : s.body) {
      const auto* model = std::get_if<plumbline::Model>(&item);
      if (model == nullptr || model->source.element != "LWPOLYLINE") continue;
      CHECK(model->segments[0].a == model->segments[model->segments.size() - 1].b);
    }
  }
}

// The texts of drawings and the names of their shapes.

#include <catch2/catch.hpp>

#include "plumbline/read.hpp"
#include "read/dxf/texts.hpp"
#include "read/svg/names.hpp"
#include "support/dxf_text.hpp"
#include "support/listing.hpp"

namespace {

using plumbline::dxf_lines;
using plumbline::dxf_with;
using plumbline::dxf::plain_text;

std::string of_dxf(const std::string& entities, const std::string& sections = {}) {
  return labels_of(evaluate(plumbline::read_dxf(dxf_with(entities, sections), "a.dxf")));
}

std::string of_svg(const std::string& content) {
  const std::string root =
      "<svg xmlns='http://www.w3.org/2000/svg' "
      "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' viewBox='0 0 100 200'>\n";
  return labels_of(evaluate(plumbline::read_svg(root + content + "</svg>", "a.svg")));
}

}  // namespace

TEST_CASE("a TEXT is a label where it stands, a justified one at its alignment point") {
  CHECK(of_dxf("0 TEXT 8 A 10 1 20 2 1 Bath") == "Bath at 1 2 | a.dxf:6 TEXT (A)\n");
  CHECK(of_dxf("0 TEXT 8 A 10 1 20 2 11 9 21 9 72 0 1 Bath") == "Bath at 1 2 | a.dxf:6 TEXT (A)\n");
  CHECK(of_dxf("0 TEXT 8 A 10 1 20 2 11 9 21 8 72 1 1 Bath") == "Bath at 9 8 | a.dxf:6 TEXT (A)\n");
  CHECK(of_dxf("0 TEXT 8 A 10 1 20 2 11 9 21 8 73 2 1 Bath") == "Bath at 9 8 | a.dxf:6 TEXT (A)\n");
  CHECK(of_dxf("0 TEXT 8 A 10 1 20 2 11 4 21 8 72 5 1 Bath") ==
        "Bath at 2.5 5 | a.dxf:6 TEXT (A)\n");
  CHECK(of_dxf("0 TEXT 8 A 10 1 20 2 230 -1 1 Bath") == "Bath at -1 2 | a.dxf:6 TEXT (A)\n");
  CHECK(of_dxf("0 TEXT 8 A 10 1 20 2 1 %%u").empty());
}

TEST_CASE("a text without a place is listed, and nothing is lost with it") {
  const auto set = evaluate(plumbline::read_dxf(dxf_with("0 TEXT 8 A 1 Bath 10 x 20 2"), "a.dxf"));
  CHECK(rejected_of(set) == "a.dxf:6 TEXT (A): not a number: group 10: x\n");
  CHECK(lost_of(set).empty());
}

TEST_CASE("an MTEXT is one line without its formatting, its pieces joined") {
  CHECK(of_dxf("0 MTEXT 8 A 10 1 20 2 71 5 3 {\\fArial|b0; 3 Living\\P 1 room}") ==
        "Living room at 1 2 | a.dxf:6 MTEXT (A)\n");
  CHECK(plain_text("{\\fArial|b1;\\H1.5x;Room} \\LA\\l~", true) == "Room A~");
  CHECK(plain_text("a\\~b\\Pc^Jd\\\\e\\{f\\}", true) == "a b c d\\e{f}");
  CHECK(plain_text("\\S1/2; x\\S1#4; \\S+0^-1;", true) == "1/2 x1/4 +0 -1");
  CHECK(plain_text("\\pxqc;\\C1;mid\\A", true) == "mid");
  CHECK(plain_text("{a\\b}  c ", false) == "{a\\b} c");
  CHECK(plain_text("%%c10 90%%d %%P1 %%uA%%u 5%%% %%065", false) ==
        "\u00d810 90\u00b0 \u00b11 A 5% A");
}

TEST_CASE("attributes of inserts are labels unless invisible, definitions only where constant") {
  const std::string blocks =
      "0 SECTION 2 BLOCKS 0 BLOCK 2 R 10 0 20 0 0 ATTDEF 8 0 70 2 10 1 20 1 1 Fixed 2 T "
      "0 ATTDEF 8 0 70 0 10 1 20 1 1 Default 2 U 0 TEXT 8 0 10 0 20 0 1 In 0 ENDBLK 0 ENDSEC";
  CHECK(of_dxf("0 INSERT 2 R 8 W 10 10 20 0 66 1 0 ATTRIB 8 W 10 5 20 5 1 Hall 2 U "
               "0 ATTRIB 8 W 70 1 10 5 20 5 1 Secret 2 V 0 SEQEND 0 ATTDEF 8 W 70 2 10 0 20 0 1 X",
               blocks) ==
        "Fixed at 11 1 | a.dxf:14 ATTDEF (W/R)\n"
        "In at 10 0 | a.dxf:42 TEXT (W/R)\n"
        "Hall at 5 5 | a.dxf:72 ATTRIB (W)\n");
}

TEST_CASE("labels know the layer that they lie on, through inserts and where it is hidden") {
  const std::string sections =
      "0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 OFF 62 -7 0 ENDTAB 0 ENDSEC "
      "0 SECTION 2 BLOCKS 0 BLOCK 2 R 10 0 20 0 0 TEXT 8 0 10 0 20 0 1 Zero 0 TEXT 8 N 10 0 20 0 1 "
      "Own 0 ENDBLK 0 ENDSEC";
  const auto set = evaluate(plumbline::read_dxf(
      dxf_with("0 INSERT 2 R 8 W 10 0 20 0 0 TEXT 8 OFF 10 0 20 0 1 Gone", sections), "a.dxf"));
  REQUIRE(set.labels.size() == 2);
  CHECK(of_dxf("0 INSERT 2 R 8 W 60 1 10 0 20 0 66 1 0 ATTRIB 8 W 10 5 20 5 1 Hall 0 SEQEND",
               sections)
            .empty());
  CHECK(set.sources[set.labels[0].source].layer == "W");
  CHECK(set.sources[set.labels[1].source].layer == "N");
}

TEST_CASE("an SVG text is a label at its place, its lines joined") {
  CHECK(of_svg("<text x='1' y='2.5'> Living\n  room </text>") ==
        "Living room at 1 2.5 | a.svg:2:1 text\n");
  CHECK(of_svg("<g transform='translate(10)'><text id='t' transform='scale(2)' x='1 2 3' y='50%'>"
               "<tspan>A</tspan> <tspan y='9'>B</tspan></text></g>") ==
        "A B at 12 200 | a.svg:2:30 text #t\n");
  CHECK(of_svg("<text><tspan x='3' y='4'>Ki<tspan>tchen</tspan></tspan><title>no</title></text>") ==
        "Kitchen at 3 4 | a.svg:2:1 text\n");
  CHECK(of_svg("<text x='1'> </text><text display='none'>x</text>").empty());
  CHECK(of_svg("<text><textPath href='#p'>round</textPath></text>").empty());
}

TEST_CASE("a shape is named by its title, else its label, else an id that a person gave") {
  CHECK(of_svg("<rect id='bath' width='1' height='1' inkscape:label='Bath'><title> The\nbath "
               "</title></rect><g inkscape:label='no'><title>no</title>\n"
               "<rect id='r1' width='1' height='1' inkscape:label='Hall'/></g>\n"
               "<rect id='Kitchen' width='1' height='1'/><path id='path12' d='M0 0H1'/>") ==
        "The bath | a.svg:2:1 rect #bath\n"
        "Hall | a.svg:4:1 rect #r1 (no)\n"
        "Kitchen | a.svg:5:1 rect #Kitchen\n");
  using plumbline::is_generated_id;
  for (const char* id :
       {"", "path3456-7", "rect45", "polygon7-3", "svg_12", "_12", "_x31_2", "Path_3",
        "Rectangle 1", "XMLID_12_", "path", "SVGID_1_", "Vector", "0a1b2c3d-0a1b-2c3d"}) {
    CAPTURE(id);
    CHECK(is_generated_id(id));
  }
  for (const char* id : {"kitchen", "room_12", "A1", "pathway", "R101", "Bad"}) {
    CAPTURE(id);
    CHECK(!is_generated_id(id));
  }
}

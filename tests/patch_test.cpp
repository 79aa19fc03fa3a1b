#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "plumbline/edits.hpp"
#include "plumbline/patch.hpp"
#include "plumbline/pipeline.hpp"
#include "plumbline/read.hpp"

using namespace plumbline;

namespace {

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

/// The drawing with another segment in place of its s-th one.
SegmentSet with(const SegmentSet& input, std::size_t s, const Segment& segment) {
  SegmentSet output = input;
  output.segments = {};
  for (std::size_t i = 0; i < input.segments.size(); ++i) {
    output.segments.push_back(i == s ? segment : input.segments[i]);
  }
  return output;
}

/// The drawing and a virtual line.
SegmentSet with_virtual(SegmentSet set, const Segment& segment) {
  Source source;
  source.element = "line";
  source.layer = kVirtualLayer;
  const SourceId id = set.add_source(source);
  set.add(segment, id);
  return set;
}

SegmentSet dxf(const std::string& text) { return evaluate(read_dxf(text, "a.dxf")); }
SegmentSet svg(const std::string& text) { return evaluate(read_svg(text, "a.svg")); }

/// A text of groups, one for each pair of words: "0 LINE 8 WALLS".
std::string groups(const std::string& words, const std::string& line_end = "\n") {
  std::string text;
  for (const char c : words) text += c == ' ' ? line_end : std::string(1, c);
  return text + line_end;
}

/// The lines of a text with blanks between them.
std::string words(const std::string& text) {
  std::istringstream stream(text);
  std::string result, word;
  while (stream >> word) result += (result.empty() ? "" : " ") + word;
  return result;
}

const std::string kLine = "0 LINE 5 2F 8 WALLS 62 1 10 0 20 0 30 7.5 11 4 21 0 31 7.5";
const std::string kArc = "0 ARC 5 30 8 ROUND 10 2 20 2 40 1 50 0 51 90";
const std::string kBegin = "0 SECTION 2 ENTITIES ", kEnd = " 0 ENDSEC 0 EOF";

}  // namespace

TEST_CASE("nothing changed: the patched file is the file") {
  const std::string text = groups(kBegin + kLine + " " + kArc + kEnd, "\r\n");
  const auto patch = patched_dxf(text, dxf(text), dxf(text));
  REQUIRE(patch);
  CHECK(patch->text == text);
  CHECK(patch->replaced.empty());
}

TEST_CASE("a changed LINE keeps layer, colour and handle; an ARC stays an ARC") {
  for (const std::string end : {"\n", "\r\n"}) {
    const std::string text = groups(kBegin + kLine + " " + kArc + kEnd, end);
    const auto patch =
        patched_dxf(text, dxf(text), with(dxf(text), 0, {{0, 0}, {5, Rational(1, 3)}}));
    REQUIRE(patch);
    CHECK(words(patch->text) ==
          kBegin +
              "0 LINE 5 2F 8 WALLS 62 1 10 0.0 20 0.0 30 0.0 11 5.0 21 0.3333333333333333 31 0.0 " +
              kArc + kEnd);
    CHECK(holds(patch->text, "0.3333333333333333" + end));
    REQUIRE(patch->replaced.size() == 1);
    CHECK(patch->replaced[0].id == "2F");
  }
}

TEST_CASE("an edited ARC becomes lines of its chords") {
  const std::string text = groups(kBegin + kLine + " " + kArc + kEnd);
  const SegmentSet input = dxf(text);
  const Segment chord = input.segments[1];
  const auto patch = patched_dxf(text, input, with(input, 1, {chord.a, {9, 9}}));
  REQUIRE(patch);
  CHECK_FALSE(holds(patch->text, "ARC"));
  CHECK(holds(patch->text, groups(kLine)));
  CHECK(dxf(patch->text).segments.size() == input.segments.size());
}

TEST_CASE("virtual lines lie on a layer of their own, which the table gets once") {
  const std::string table =
      "0 SECTION 2 TABLES 0 TABLE 2 LAYER 70 1 0 LAYER 2 WALLS 70 0 62 3 6 CONTINUOUS 0 ENDTAB 0 "
      "ENDSEC ";
  const std::string text = groups(table + kBegin + kLine + kEnd);
  const SegmentSet input = dxf(text);
  const auto patch = patched_dxf(text, input, with_virtual(input, {{1, 1}, {2, 1}}));
  REQUIRE(patch);
  const SegmentSet again = dxf(patch->text);
  CHECK(again.segments[1] == Segment{{1, 1}, {2, 1}});
  CHECK(again.sources[again.segment_source[1]].layer == kVirtualLayer);
  REQUIRE(again.layers.size() == 2);
  CHECK(again.layers[1].name == kVirtualLayer);
  const auto more = patched_dxf(patch->text, again, with_virtual(again, {{1, 2}, {2, 2}}));
  REQUIRE(more);
  CHECK(dxf(more->text).layers.size() == 2);
}

TEST_CASE("new entities of later DXF have handles that no other has, and owners") {
  const std::string head = "0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 9 $HANDSEED 5 31 0 ENDSEC ";
  const std::string line =
      "0 LINE 5 2F 102 {ACAD_REACTORS 330 9 102 } 330 1F 100 AcDbEntity 8 0 100 AcDbLine 10 0 20 0 "
      "11 "
      "4 21 0";
  const std::string text = groups(head + kBegin + line + kEnd);
  const SegmentSet input = dxf(text);
  const auto patch = patched_dxf(text, input, with_virtual(input, {{1, 1}, {2, 1}}));
  REQUIRE(patch);
  CHECK(holds(words(patch->text),
              "0 LINE 5 31 330 1F 100 AcDbEntity 8 plumbline-virtual 100 AcDbLine"));
  CHECK(holds(words(patch->text), "9 $HANDSEED 5 32"));
  CHECK(holds(patch->text, groups(line)));
}

TEST_CASE("what a block has gives way to lines wherever it is inserted; its texts stay") {
  const std::string block =
      "0 SECTION 2 BLOCKS 0 BLOCK 2 DOOR 10 0 20 0 0 LINE 8 0 10 0 20 0 11 1 21 0 0 TEXT 8 0 10 0 "
      "20 0 "
      "40 1 1 D 0 ENDBLK 0 ENDSEC ";
  const std::string text =
      groups(block + kBegin + "0 INSERT 8 A 2 DOOR 10 5 20 5 0 INSERT 8 B 2 DOOR 10 8 20 8" + kEnd);
  const SegmentSet input = dxf(text);
  REQUIRE(input.segments.size() == 2);
  const auto patch = patched_dxf(text, input, with(input, 0, {{5, 5}, {7, 5}}));
  REQUIRE(patch);
  const SegmentSet again = dxf(patch->text);
  REQUIRE(again.segments.size() == 2);
  CHECK(again.segments[0] == Segment{{5, 5}, {7, 5}});
  CHECK(again.segments[1] == Segment{{8, 8}, {9, 8}});
  CHECK(again.sources[again.segment_source[0]].layer == "A");
  CHECK(again.sources[again.segment_source[1]].layer == "B");
  CHECK(again.labels.size() == 2);
}

TEST_CASE("of a POLYLINE its vertices go, too") {
  const std::string text = groups(kBegin +
                                  "0 POLYLINE 8 W 66 1 70 0 0 VERTEX 8 W 10 0 20 0 0 VERTEX 8 W 10 "
                                  "1 20 0 0 VERTEX 8 W 10 1 20 1 0 "
                                  "SEQEND " +
                                  kLine + kEnd);
  const SegmentSet input = dxf(text);
  const auto patch = patched_dxf(text, input, with(input, 1, {{1, 0}, {1, 2}}));
  REQUIRE(patch);
  CHECK_FALSE(holds(patch->text, "VERTEX"));
  CHECK_FALSE(holds(patch->text, "SEQEND"));
  CHECK(dxf(patch->text).segments.size() == 3);
}

TEST_CASE("a text that is not the one that was read is not patched") {
  const std::string text = groups(kBegin + kLine + kEnd);
  const SegmentSet input = dxf(text), output = with(input, 0, {{0, 0}, {5, 0}});
  CHECK_FALSE(patched_dxf("999\nmore\n" + text, input, output));
  CHECK_FALSE(patched_dxf("", input, output));
  CHECK_FALSE(patched_dxf("AutoCAD Binary DXF\r\n\x1a", input, output));
  CHECK_FALSE(patched_svg("<svg/>", input, output));
}

TEST_CASE("SVG: paths at the end, in the root's coordinates, with id, class and strokes") {
  const std::string rest = R"(<circle cx="2" cy="2" r="1"/></g><text x="1" y="1">a</text>)";
  const std::string text = R"x(<svg xmlns="http://www.w3.org/2000/svg"><g transform="scale(2)">)x"
                           R"(<line id="w" x2="4" stroke="red"><title>Hall</title></line>)" +
                           rest + "</svg>\n";
  const SegmentSet input = svg(text);
  CHECK(patched_svg(text, input, input)->text == text);
  const auto patch = patched_svg(text, input, with(input, 0, {{0, 0}, {9, 0}}));
  REQUIRE(patch);
  CHECK(holds(patch->text, R"(<path id="w" stroke="red" d="M0 0L9 0"><title>Hall</title></path>)"));
  CHECK(holds(patch->text, R"x(<g transform="scale(2)">)x" + rest));
  const SegmentSet again = svg(patch->text);
  CHECK(again.segments.size() == input.segments.size());
  CHECK(again.segments[again.segments.size() - 1] == Segment{{0, 0}, {9, 0}});
}

TEST_CASE("SVG: what was filled is not filled as lines, in front of everything") {
  const std::string text =
      R"(<svg xmlns="http://www.w3.org/2000/svg"><rect width="4" height="3" fill="red" )"
      R"(style='stroke:"a";fill:red'/><rect y="5" width="4" height="3" class="b"/></svg>)";
  const SegmentSet input = svg(text);
  const auto first = patched_svg(text, input, with(input, 0, {{0, 0}, {5, 0}}));
  REQUIRE(first);
  CHECK(holds(first->text, R"(<path style='stroke:"a";fill:red;fill:none' d=)"));
  const auto second = patched_svg(text, input, with(input, 4, {{0, 5}, {5, 5}}));
  REQUIRE(second);
  CHECK(holds(second->text, R"(<path class="b" style="fill:none" d=)"));
}

TEST_CASE("SVG: layers stay, virtual lines get one; prefixes of names are kept") {
  const std::string text =
      R"(<s:svg xmlns:s="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape">)"
      R"(<!-- </s:svg> --><s:g inkscape:groupmode="layer" inkscape:label="A &amp; &quot;B&quot;"><s:line x2="4"/></s:g></s:svg>)";
  const SegmentSet input = svg(text);
  const auto patch =
      patched_svg(text, input, with_virtual(with(input, 0, {{0, 0}, {9, 0}}), {{1, 1}, {2, 1}}));
  REQUIRE(patch);
  const SegmentSet again = svg(patch->text);
  REQUIRE(again.segments.size() == 2);
  CHECK(again.sources[again.segment_source[0]].layer == "A & \"B\"");
  CHECK(again.sources[again.segment_source[1]].layer == kVirtualLayer);
}

TEST_CASE("SVG: what is used in several places has a path for all of them, without id") {
  const std::string text =
      R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"><defs><g id="d">)"
      R"(<line id="leaf" x2="1"/></g></defs><use xlink:href="#d"/><use xlink:href="#d" x="5"/></svg>)";
  const SegmentSet input = svg(text);
  REQUIRE(input.segments.size() == 2);
  const auto patch = patched_svg(text, input, with(input, 1, {{5, 0}, {7, 0}}));
  REQUIRE(patch);
  CHECK(holds(patch->text, "<path d=\"M0 0L1 0M5 0L7 0\"/>"));
  CHECK(svg(patch->text).segments.size() == 2);
}

TEST_CASE("a curve that would be cut at other points once a line has changed becomes lines, too") {
  const std::string text = R"(<svg xmlns="http://www.w3.org/2000/svg"><line x2="2.7" y2="1.1"/>)"
                           R"(<circle cx="3" cy="1" r="1"/><circle cx="9" cy="1" r="1"/></svg>)";
  std::ofstream("cut.svg") << text;
  const SegmentSet input = evaluate(read("cut.svg"));
  const SegmentSet output = with(input, 0, {{0, 0}, {1, Rational(11, 27)}});
  const auto alone = patched_svg(text, input, output);
  REQUIRE(alone);
  CHECK(svg(alone->text).segments.size() < input.segments.size());  // a vertex of the circle went
  const PatchedFile patched = patched_file("cut.svg", "svg", {}, input, output);
  CHECK(patched.why_not.empty());
  REQUIRE(patched.replaced.size() == 2);
  CHECK(patched.replaced[1].element == "circle");
  CHECK(holds(patched.text, R"(<circle cx="9" cy="1" r="1"/>)"));
  CHECK(svg(patched.text).segments.size() == input.segments.size());
}

TEST_CASE("a file of another format, or one that holds something else by now, is not patched") {
  std::ofstream("other.svg") << R"(<svg xmlns="http://www.w3.org/2000/svg"><line x2="2"/></svg>)";
  const SegmentSet input = evaluate(read("other.svg"));
  const SegmentSet output = with(input, 0, {{0, 0}, {3, 0}});
  CHECK(holds(patched_file("other.svg", "dxf", {}, input, output).why_not, "made of a .svg one"));
  std::ofstream("other.svg")
      << R"(<svg xmlns="http://www.w3.org/2000/svg"><line x2="2"/><line y2="1"/></svg>)";
  const PatchedFile patched = patched_file("other.svg", "svg", {}, input, output);
  CHECK(holds(patched.why_not, "read again"));
  CHECK(patched.text.empty());
}

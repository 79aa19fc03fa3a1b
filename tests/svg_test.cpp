// Elements of SVG: shapes, containers, what is not understood, and where each thing stands.

#include <catch2/catch.hpp>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "support/listing.hpp"

using plumbline::evaluate;
using plumbline::read_svg;

namespace {

plumbline::SegmentSet drawn(const std::string& content) {
  return evaluate(read_svg("<svg>" + content + "</svg>", "a.svg"));
}

std::string segments(const std::string& content) { return segments_of(drawn(content)); }
std::string rejected(const std::string& content) { return rejected_of(drawn(content)); }
std::string remarks(const std::string& content) { return remarks_of(drawn(content)); }

}  // namespace

TEST_CASE("every segment knows line, column, element, id and the names of the groups above it") {
  CHECK(listing(read_svg(R"(<?xml version="1.0"?>
<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">
<svg xmlns="http://www.w3.org/2000/svg" id="sheet" viewBox="0 0 59.528 84.189">
  <line x1="0.1" y1="0" x2="2" y2="3"/>
  <g id="layer1" inkscape:label="Ground floor" inkscape:groupmode="layer"
     xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape">
    <!-- <line x2="7"/> --><g><rect id="r1" width="1" height="2"/>
    <g id="walls"><polyline id="p"
         points="0,0 5,5"/></g></g></g>
</svg>
)",
                         "plan.svg")) ==
        "0.1 0, 2 3 | plan.svg:4:3 line\n"
        "0 0, 1 0 | plan.svg:7:31 rect #r1 (Ground floor)\n"
        "1 0, 1 2 | plan.svg:7:31 rect #r1 (Ground floor)\n"
        "1 2, 0 2 | plan.svg:7:31 rect #r1 (Ground floor)\n"
        "0 2, 0 0 | plan.svg:7:31 rect #r1 (Ground floor)\n"
        "0 0, 5 5 | plan.svg:8:19 polyline #p (Ground floor/walls)\n");
}

TEST_CASE("lengths are numbers or have a unit, missing ones are 0") {
  CHECK(segments("<line x1='1px' y1=' .5 ' x2='1e1' y2='-2.5px'/>") == "1 0.5, 10 -2.5\n");
  CHECK(segments("<line x2='4'/>") == "0 0, 4 0\n");
  CHECK(segments("<rect x='1' y='2' width='0.1' height='3px'/>") ==
        "1 2, 1.1 2\n1.1 2, 1.1 5\n1.1 5, 1 5\n1 5, 1 2\n");
  // CSS Values 3, 6.2: 1in = 2.54cm = 96px, 1cm = 10mm = 40Q, 1in = 72pt = 6pc.
  CHECK(segments("<line x1='1in' y1='2.54cm' x2='25.4mm' y2='6pc'/>").empty());
  CHECK(segments("<line x2='-1in' y2='127mm'/>") == "0 0, -96 480\n");
  CHECK(segments("<line x2='3pt' y2='1pc'/>") == "0 0, 4 16\n");
  CHECK(segments("<line x2='1mm' y2='1cm'/>") == "0 0, 480/127 4800/127\n");
  CHECK(segments("<line x2='101.6Q' y2='0.5IN'/>") == "0 0, 96 48\n");
}

TEST_CASE("percentages refer to the nearest viewport: its viewBox, or else its extents") {
  const auto read = [](const std::string& root) {
    return segments_of(
        evaluate(read_svg("<svg " + root + "><line x1='50%' y2='-10%'/></svg>", "a.svg")));
  };
  CHECK(read("viewBox='1 2 40 30' width='7'") == "20 0, 0 -3\n");
  CHECK(read("width='1in' height='2in'") == "48 0, 0 -19.2\n");
  CHECK(read("width='100%' height='2in'").empty());
  // SVG 1.1, 7.10: a percentage of a radius refers to sqrt((width^2 + height^2) / 2).
  const auto set = evaluate(read_svg("<svg viewBox='0 0 7 1'><circle r='10%'/></svg>", "a.svg"));
  CHECK(to_text(set.segments[0].a) == "0.5 0");
  CHECK(set.ledger.size() == 1);
  const auto irrational =
      evaluate(read_svg("<svg viewBox='0 0 1 2'><circle r='100%'/></svg>", "a.svg"));
  CHECK(plumbline::nearest(irrational.segments[0].a).x == Approx(1.5811388300841898));
  CHECK(irrational.ledger.at(1).what == "r=\"100%\"");
}

TEST_CASE("a shape with a length that is not understood is rejected, naming the attribute") {
  const auto [element, reason] = GENERATE(table<std::string, std::string>({
      {"<line x2='50%'/>", "line: percentage of an unknown extent: x2=\"50%\""},
      {"<line x2='1em'/>", "line: unit em is not understood: x2=\"1em\""},
      {"<circle r='50%'/>", "circle: percentage of an unknown extent: r=\"50%\""},
      {"<circle cx='1ex' r='1'/>", "circle: unit ex is not understood: cx=\"1ex\""},
      {"<line x2='5 px'/>", "line: not a length: x2=\"5 px\""},
      {"<line x2=''/>", "line: not a length: x2=\"\""},
      {"<line x2='1,5'/>", "line: unit ,5 is not understood: x2=\"1,5\""},
      {"<line y1='auto'/>", "line: not a length: y1=\"auto\""},
      {"<line y2='1e99999999999'/>", "line: decimal exponent beyond 10000: y2=\"1e99999999999\""},
      {"<rect width='1vw' height='1'/>", "rect: unit vw is not understood: width=\"1vw\""},
  }));
  CAPTURE(element);
  CHECK(segments(element).empty());
  CHECK(rejected(element) == "a.svg:1:6 " + reason + "\n");
}

TEST_CASE("a rect that is not drawn is rejected") {
  const auto [attributes, reason] = GENERATE(table<std::string, std::string>({
      {"width='0' height='1'", "zero width: width=\"0\""},
      {"width='1' height='0.0'", "zero height: height=\"0.0\""},
      {"width='-1' height='1'", "negative width: width=\"-1\""},
      {"height='1'", "rect without width"},
      {"width='1'", "rect without height"},
      {"width='1' height='1' rx='-.1'", "negative rx: rx=\"-.1\""},
  }));
  CAPTURE(attributes);
  CHECK(segments("<rect " + attributes + "/>").empty());
  CHECK(rejected("<rect " + attributes + "/>") == "a.svg:1:6 rect: " + reason + "\n");
}

TEST_CASE("corner radii of which one is 0 leave a rect square") {
  for (const std::string radii : {"rx='0'", "rx='0' ry='5'", "rx='5' ry='0px'", "rx='auto'"}) {
    CHECK(drawn("<rect width='1' height='1' " + radii + "/>").segments.size() == 4);
  }
}

TEST_CASE("a line without length is rejected with its place") {
  CHECK(rejected("<g id='w'>\n<line id='z' x1='1' y1='2' x2='1.0' y2='2'/></g>") ==
        "a.svg:2:1 line #z (w): zero-length segment: 1 2, 1 2\n");
}

TEST_CASE("every drawn element that is not understood is rejected by name and place") {
  for (const std::string name : {"text", "image", "switch", "foreignObject", "lien"}) {
    CHECK(rejected("<g id='a'><" + name + " id='x'><line x2='1'/></" + name + "></g>") ==
          "a.svg:1:16 " + name + " #x (a): element " + name + " is not understood yet\n");
  }
}

TEST_CASE("what is not drawn in its place is listed where it holds a drawing") {
  for (const std::string name : {"defs", "symbol", "clipPath", "mask", "pattern", "marker"}) {
    const std::string full = "<" + name + "><g><path d='M0 0H1'/></g></" + name + ">";
    CHECK(segments(full).empty());
    CHECK(rejected(full) == "a.svg:1:6 " + name + ": not drawn directly\n");
    CHECK(rejected("<" + name + "><linearGradient/></" + name + ">").empty());
  }
  CHECK(rejected("<line x2='1'><title>wall</title></line>").empty());
  CHECK(listing(read_svg("<svg><line x2='1'><rect/></line></svg>", "a.svg")) ==
        "0 0, 1 0 | a.svg:1:6 line\n"
        "rejected:\n"
        "a.svg:1:19 rect: not drawn directly\n");
}

TEST_CASE("descriptions, styles and other vocabularies are no items of the drawing") {
  CHECK(listing(read_svg(
            "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sodipodi='http://sodipodi.example'>"
            "<title>t</title><desc>d</desc><metadata><x/></metadata><style>g{}</style><script/>"
            "<sodipodi:namedview><sodipodi:guide/></sodipodi:namedview>"
            "<line sodipodi:type='arc' x2='1'/></svg>",
            "a.svg")) == "0 0, 1 0 | a.svg:1:222 line\n");
}

TEST_CASE("elements are known by their namespace, not by their prefix") {
  CHECK(segments_of(evaluate(read_svg("<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:g>"
                                      "<s:line x2='1'/></s:g></s:svg>",
                                      "a.svg"))) == "0 0, 1 0\n");
  CHECK(listing(read_svg("<svg xmlns='http://www.w3.org/2000/svg'>"
                         "<g xmlns='http://other.example'><line x2='1'/></g><line x2='2'/></svg>",
                         "a.svg")) ==
        "0 0, 2 0 | a.svg:1:91 line\n"
        "rejected:\n"
        "a.svg:1:41 g: not drawn directly\n");
  CHECK_THROWS_AS(read_svg("<svg xmlns='http://other.example'/>", "a.svg"), plumbline::Error);
}

TEST_CASE("geometry that a style attribute places is rejected") {
  CHECK(rejected("<g style='fill:none; transform : rotate(3deg)'><line x2='1'/></g>") ==
        "a.svg:1:6 g: property transform of a style is not understood yet: "
        "fill:none; transform : rotate(3deg)\n");
  CHECK(rejected("<rect width='1' height='1' style='rx:3'/>") ==
        "a.svg:1:6 rect: property rx of a style is not understood yet: rx:3\n");
  CHECK(rejected("<line x2='1' transform='scale(2)' transform-origin='1 1'/>") ==
        "a.svg:1:6 line: transform-origin is not understood yet: 1 1\n");
  CHECK(segments("<line x2='1' style='fill:none;stroke-width:2;rx:3;;'/>") == "0 0, 1 0\n");
}

TEST_CASE("what is no line work is harmless; what may be is lost") {
  CHECK(lost_of(drawn("<text>a</text><image/><foreignObject/><rect width='0' height='1'/>"
                      "<path d='M1 1'/><line/><defs><line x2='1'/></defs><switch><text/></switch>"
                      "<flowRoot><flowRegion><rect width='3' height='4'/></flowRegion></flowRoot>"
                      "<path d='none'/>"))
            .empty());
  CHECK(lost_of(drawn("<path d='M0 0L1 1X'/><use href='#none'/><switch><line x2='1'/></switch>"
                      "<rect width='-1' height='1'/><line x2='a'/>")) ==
        "path use switch rect line ");
}

TEST_CASE("what maps the root's user units to a page is listed, and not applied") {
  const auto set =
      evaluate(read_svg("<svg transform=\"scale(2)\"><line x2=\"1\" y2=\"1\"/></svg>", "a.svg"));
  CHECK(segments_of(set) == "0 0, 1 1\n");
  CHECK(remarks_of(set).find("1:1 svg: transform of the root svg") != std::string::npos);
}

TEST_CASE("a style sheet that moves or hides is listed, one that colours is not") {
  const std::string line = "<line x2=\"1\" y2=\"1\"/>";
  CHECK(remarks("<style>line{transform:scale(2)}</style>" + line).find("style sheets are not") !=
        std::string::npos);
  CHECK(remarks("<style>.h{display:none}</style>" + line) != "");
  CHECK(remarks("<style>line{stroke:red}</style>" + line) == "");
  CHECK(
      remarks("<defs><style>line{visibility:hidden}</style></defs>" + line) ==
      "a.svg:1:12 style: style sheets are not interpreted: visibility: line{visibility:hidden}\n");
}

TEST_CASE("a nested svg is moved by x and y; its clipping is listed, and not applied") {
  CHECK(listing(read_svg("<svg x='7' viewBox='0 0 1 1'><svg id='s' x='.5' y='2px' width='100%'>"
                         "<line x2='1'/></svg></svg>",
                         "a.svg")) == "0.5 2, 1.5 2 | a.svg:1:70 line (s)\n");
  CHECK(listing(read_svg("<svg><svg width='5'><line x2='1'/></svg></svg>", "a.svg")) ==
        "0 0, 1 0 | a.svg:1:21 line\n"
        "remarks:\n"
        "a.svg:1:6 svg: clipping by a viewport is not applied\n");
  CHECK(remarks("<svg width='5' overflow='visible'><line x2='1'/></svg>").empty());
  CHECK(listing(read_svg("<svg><svg viewBox='0 0 2 2'><line x2='1'/></svg></svg>", "a.svg")) ==
        "rejected:\n"
        "a.svg:1:6 svg: viewBox in a viewport of unknown extent: viewBox=\"0 0 2 2\"\n");
}

TEST_CASE("groups nested 200,000 deep are read, evaluated and freed") {
  std::string text = "<svg>";
  for (int i = 0; i < 200'000; ++i) text += "<g id='g' transform='translate(1)'>";
  text += "<line x2='1'/>";
  for (int i = 0; i < 200'000; ++i) text += "</g>";
  CHECK(segments_of(evaluate(read_svg(text + "</svg>", "a.svg"))) == "200000 0, 200001 0\n");
}

TEST_CASE("numbers that would fill the memory are refused") {
  std::string points;
  for (int i = 0; i < 40'000; ++i) points += "1e9999 ";
  try {
    drawn("<polyline points='" + points + "'/>");
    FAIL("no error");
  } catch (const plumbline::Error& error) {
    CHECK(error.code() == plumbline::ErrorCode::Limit);
  }
}

// References, symbols, viewports and what is hidden.

#include <catch2/catch.hpp>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "support/listing.hpp"

using namespace plumbline;

namespace {

constexpr const char* kRoot =
    "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
    "viewBox='0 0 200 100'>\n";

Structure structure(const std::string& content, bool hidden = false) {
  ReadOptions options;
  options.hidden = hidden;
  return read_svg(kRoot + content + "</svg>", "a.svg", options);
}

SegmentSet drawn(const std::string& content) { return evaluate(structure(content)); }
std::string segments(const std::string& content) { return segments_of(drawn(content)); }
std::string rejected(const std::string& content) { return rejected_of(drawn(content)); }

}  // namespace

TEST_CASE("a use draws what it refers to, moved by x and y, with both names") {
  CHECK(listing(structure("<defs><g id='door'><line id='leaf' x2='1'/></g></defs>\n"
                          "<use id='a' href='#door' x='10' y='20'/>\n"
                          "<use id='b' xlink:href='#door' transform='scale(2)' x='1'/>")) ==
        "10 20, 11 20 | a.svg:2:20 line #leaf (a/door)\n"
        "2 0, 4 0 | a.svg:2:20 line #leaf (b/door)\n");
}

TEST_CASE("what is used is stored once, even where it is drawn in its place too") {
  const Structure s = structure(
      "<use href='#g' x='5'/><g id='g'><line x2='1'/></g>"
      "<use href='#g' x='7'/><path id='p' d='M0 0H9'/><use href='#p'/>");
  std::size_t models = 0;
  for (const Struct& part : s.structs) {
    for (const auto& item : part.body) models += std::holds_alternative<Model>(item) ? 1 : 0;
  }
  CHECK(models == 2);
  CHECK(segments_of(evaluate(s)) == "5 0, 6 0\n0 0, 1 0\n7 0, 8 0\n0 0, 9 0\n0 0, 9 0\n");
}

TEST_CASE("a shape is used with its own transform, and a use may be used") {
  CHECK(segments("<defs><line id='l' x2='1' transform='translate(3 0)'/>"
                 "<use id='u' href='#l' x='10'/></defs><use href='#u' x='100'/>") ==
        "113 0, 114 0\n");
}

TEST_CASE("what is defined and never used is listed, and only that") {
  CHECK(rejected("<defs>\n<line id='l' x2='1'/>\n<g><path id='p' d='M0 0H1'/><rect id='r' "
                 "width='1' height='1'/></g>\n<symbol id='s'><line/></symbol></defs>"
                 "<use href='#p'/>") ==
        "a.svg:3:1 line #l: not drawn directly\n"
        "a.svg:4:29 rect #r: not drawn directly\n"
        "a.svg:5:1 symbol #s: not drawn directly\n");
}

TEST_CASE("a use that leads nowhere is rejected") {
  CHECK(rejected("<use id='u'/>") == "a.svg:2:1 use #u: use without a reference\n");
  CHECK(rejected("<use href='#no'/>") ==
        "a.svg:2:1 use: use of an element that does not exist: #no\n");
  CHECK(rejected("<use href='other.svg#a'/>") ==
        "a.svg:2:1 use: use of another file: other.svg#a\n");
  CHECK(rejected("<clipPath id='c'/><use id='u' href='#c'/>") ==
        "a.svg:2:1 clipPath #c (u): use of an element that is not drawn\n");
  CHECK(rejected("<defs><image id='t'/></defs><use id='u' href='#t'/>") ==
        "a.svg:2:7 image #t (u): element image is not understood yet\n"
        "a.svg:2:1 defs: not drawn directly\n");
}

TEST_CASE("a cycle of references is an error with place and path") {
  const auto error = [](const std::string& content) {
    try {
      structure(content);
    } catch (const Error& problem) {
      CHECK(problem.code() == ErrorCode::BadInput);
      return std::string(problem.what());
    }
    return std::string("accepted");
  };
  CHECK(error("<g id='a'>\n<use href='#a'/></g>") == "a.svg:3:1: cycle of references: \"a/#a\"");
  CHECK(error("<use id='u' href='#u'/>") == "a.svg:2:1: cycle of references: \"#u\"");
  CHECK(error("<defs><g id='a'><use id='x' href='#b'/></g>\n<g id='b'><use id='y' href='#a'/></g>"
              "</defs><use id='z' href='#a'/>") ==
        "a.svg:3:11: cycle of references: \"z/a/x/b/#a\"");
  CHECK(error("<symbol id='s'><use href='#s' width='50%' height='50%'/></symbol><use href='#s'/>")
            .find("cycle of references") != std::string::npos);
}

TEST_CASE("references that multiply are refused, not followed for ever") {
  std::string doubling = "<defs><line id='d0' x2='1'/>";
  for (int i = 1; i <= 40; ++i) {
    const std::string use = "<use href='#d" + std::to_string(i - 1) + "'/>";
    doubling += "<g id='d" + std::to_string(i) + "'>" + use + use + "</g>";
  }
  const Structure s = structure(doubling + "</defs><use href='#d40'/>");
  CHECK_THROWS_AS(evaluate(s, {100'000}), Error);
  // Each level makes two viewports of one.
  std::string halving = "<defs><line id='h0' x2='1%'/>";
  for (int i = 1; i <= 40; ++i) {
    const std::string use = "<use href='#h" + std::to_string(i - 1) + "' height='100' width='";
    halving += "<symbol id='h" + std::to_string(i) + "'>" + use + "50%'/>" + use +
               std::to_string(51 + i) + "%'/></symbol>";
  }
  CHECK_THROWS_AS(structure(halving + "</defs><use href='#h40' width='10' height='10'/>"), Error);
}

TEST_CASE("a chain of 100,000 uses is followed") {
  std::string chain = "<line id='u0' x2='1'/>";
  for (int i = 1; i <= 100'000; ++i) {
    chain += "<use id='u" + std::to_string(i) + "' href='#u" + std::to_string(i - 1) + "'/>";
  }
  CHECK(segments("<defs>" + chain + "</defs><use href='#u100000' x='2'/>") == "2 0, 3 0\n");
}

TEST_CASE("a nested svg fits its viewBox into its viewport as preserveAspectRatio says") {
  // The viewBox is 10 x 10, from (5, 5); the viewport 40 x 20, at (100, 50).
  const auto corner = [](const std::string& fit) {
    const std::string text = segments(
        "<svg x='100' y='50' width='40' height='20' viewBox='5 5 10 10' overflow='visible'" + fit +
        "><line x1='5' y1='5' x2='15' y2='15'/></svg>");
    return text.substr(0, text.size() - 1);
  };
  CHECK(corner("") == "110 50, 130 70");
  const auto [value, drawing] = GENERATE(table<std::string, std::string>({
      {"none", "100 50, 140 70"},
      {"xMidYMid", "110 50, 130 70"},
      {"xMinYMid meet", "100 50, 120 70"},
      {"defer xMaxYMin", "120 50, 140 70"},
      {"xMidYMid slice", "100 40, 140 80"},
      {"xMaxYMin slice", "100 50, 140 90"},
      {"xMaxYMax slice", "100 30, 140 70"},
  }));
  CHECK(corner(" preserveAspectRatio='" + value + "'") == drawing);
}

TEST_CASE("a nested svg without extents is as large as what is around it") {
  CHECK(segments("<svg viewBox='0 0 10 10' overflow='visible'><line x2='10' y2='100%'/></svg>") ==
        "50 0, 150 100\n");
  CHECK(segments("<svg width='50%' height='50%' viewBox='0 0 10 10' overflow='visible'>"
                 "<line x2='100%' y2='5'/></svg>") == "25 0, 75 25\n");
}

TEST_CASE("a viewport that can't be used is rejected") {
  const auto [attributes, reason] = GENERATE(table<std::string, std::string>({
      {"viewBox='0 0 1'", "malformed viewBox: viewBox=\"0 0 1\""},
      {"viewBox='0 0 1 1 1'", "malformed viewBox: viewBox=\"0 0 1 1 1\""},
      {"viewBox='0 0 0 1'", "viewBox without extent: viewBox=\"0 0 0 1\""},
      {"viewBox='0 0 1 -1'", "negative extent of viewBox: viewBox=\"0 0 1 -1\""},
      {"width='0'", "zero width: width=\"0\""},
      {"height='-3mm'", "negative height: height=\"-3mm\""},
      {"width='wide'", "not a length: width=\"wide\""},
      {"preserveAspectRatio='xMidYmid'",
       "malformed preserveAspectRatio: preserveAspectRatio=\"xMidYmid\""},
      {"preserveAspectRatio='none all'",
       "malformed preserveAspectRatio: preserveAspectRatio=\"none all\""},
  }));
  CHECK(segments("<svg " + attributes + "><line x2='1'/></svg>").empty());
  CHECK(rejected("<svg " + attributes + "><line x2='1'/></svg>") ==
        "a.svg:2:1 svg: " + reason + "\n");
}

TEST_CASE("a symbol is drawn by use only, in a viewport of the use's extents") {
  const std::string symbol =
      "<symbol id='s' viewBox='0 0 10 10'><line x2='10' y2='10'/></symbol>\n";
  CHECK(segments(symbol).empty());
  CHECK(listing(structure(symbol + "<use id='u' href='#s' x='1' width='20' height='20'/>")) ==
        "1 0, 21 20 | a.svg:2:36 line (u/s)\n"
        "remarks:\n"
        "a.svg:2:1 symbol #s (u): clipping by a viewport is not applied\n");
  CHECK(segments(symbol + "<use href='#s'/>") == "50 0, 150 100\n");
  // Each size is a Struct of its own, each use of one size is the same.
  CHECK(structure(symbol + "<use href='#s' width='5'/><use href='#s' width='6'/>"
                           "<use href='#s' width='5' x='9'/>")
            .structs.size() == 1 + 3 + 2);
}

TEST_CASE("a use gives a nested svg its extents") {
  CHECK(segments("<defs><svg id='s' width='1' height='1' viewBox='0 0 10 10'><line x2='10'/></svg>"
                 "</defs><use href='#s'/><use href='#s' width='30' height='30'/>") ==
        "0 0, 1 0\n0 0, 30 0\n");
}

TEST_CASE("what is hidden is left out and counted by groups, or drawn where that is asked for") {
  const std::string content =
      "<g id='a' display='none'>\n<line x2='1'/><g><text/><rect/></g></g>\n"
      "<g id='b' style='fill:red; display : none'><line x2='2'/></g>\n"
      "<g id='c' visibility='hidden'><line x2='3'/>\n<line x2='4' visibility='visible'/></g>\n"
      "<g id='d' display='inline' style='visibility:collapse;visibility:visible !important'>"
      "<line x2='5'/></g><g display='none'/>";
  const SegmentSet visible = drawn(content);
  CHECK(segments_of(visible) == "0 0, 4 0\n0 0, 5 0\n");
  CHECK(rejected_of(visible) ==
        "a.svg:2:1 g #a: hidden (4 of them): display: none\n"
        "a.svg:5:31 line (c): hidden: visibility: hidden\n");
  const SegmentSet all = evaluate(structure(content, true));
  CHECK(segments_of(all) == "0 0, 1 0\n0 0, 2 0\n0 0, 3 0\n0 0, 4 0\n0 0, 5 0\n");
}

TEST_CASE("the style counts before the attribute, and a root may be hidden") {
  CHECK(segments("<g display='none' style='display:inline'><line x2='1'/></g>") == "0 0, 1 0\n");
  CHECK(rejected_of(evaluate(read_svg("<svg display='none'><line x2='1'/></svg>", "a.svg"))) ==
        "a.svg:1:1 svg: hidden: display: none\n");
}

TEST_CASE("hidden definitions are drawn by a visible use, visible ones not by a hidden use") {
  const std::string content =
      "<g display='none'><line id='l' x2='1'/></g><use href='#l' x='10'/>"
      "<g visibility='hidden'><use id='h' href='#l' x='20'/></g>";
  CHECK(segments(content) == "10 0, 11 0\n");
}

TEST_CASE("Inkscape's layers are Structs of category layer and declared") {
  const std::string of_inkscape = "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape'/>";
  const Structure s =
      structure("<g id='g1' inkscape:groupmode='layer' inkscape:label='Walls' " + of_inkscape +
                "<g id='g2' inkscape:groupmode='layer' style='display:none' " + of_inkscape);
  CHECK(s.structs.at(1).name == "Walls");
  CHECK(s.structs.at(1).category == "layer");
  CHECK(layers_of(evaluate(s)) == "Walls -\ng2 - hidden\n");
}

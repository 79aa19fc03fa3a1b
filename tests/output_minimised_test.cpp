// The minimised drawing on a screen, as an issue and as a picture.

#include "plumbline/output/minimised.hpp"

#include <catch2/catch.hpp>
#include <pugixml.hpp>
#include <stdexcept>

#include "plumbline/arrange.hpp"
#include "plumbline/engines/lar.hpp"
#include "plumbline/error.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// The exact answer to the segments but the first of them.
Engine without_first() {
  return {"forgetful",
          "1.5",
          "a forgetful engine",
          {{"times", Parameter::Type::Integer, "how often [default: 1]"}},
          [](const SegmentSet& input, const Parameters& parameters, std::size_t threads) {
            LineWork work = rounded(input);
            if (!work.segments.empty()) work.segments[0].b = work.segments[0].a;
            Answer answer;
            answer.engine = "forgetful";
            answer.version = "1.5";
            answer.title = "a forgetful engine";
            answer.short_title = "forgetful";
            answer.parameters = parameters;
            answer.complex = nearest(arrange(work, threads));
            return answer;
          }};
}

Minimised of_crossing_thirds() {
  Minimised m = minimised(segments("0 0 3 1  0 1 3 0  0 0 0 1  7 7 9 7.25"), without_first(),
                          {{"times", std::int64_t{3}}});
  return m;
}

/// Of the elements of that name, those with the attribute value.
std::size_t count(const std::string& svg, const char* query) {
  pugi::xml_document document;
  REQUIRE(document.load_string(svg.c_str()));
  return document.select_nodes(query).size();
}

}  // namespace

TEST_CASE("the screen says what is wrong, where, with which numbers and versions") {
  const std::string text = to_text(of_crossing_thirds());
  CAPTURE(text);
  CHECK_THAT(text, Catch::StartsWith("disagree: face lost, in 3 of 4 segments\n"));
  CHECK_THAT(text, Catch::Contains("none can be left out, nor a number be simpler; "));
  CHECK_THAT(text, Catch::Contains("\n0,0,0,1\n"));
  CHECK_THAT(text, Catch::Contains("vertices  "));
  CHECK_THAT(text,
             Catch::Contains("engine forgetful 1.5 (a forgetful engine), times 3, tolerance "));
  CHECK_THAT(text, Catch::Contains("doubles can hold a right answer"));
}

TEST_CASE("an engine that is right needs a line or two") {
  const Minimised m = minimised(segments("0 0 3 1  0 1 3 0"), lar::engine());
  CHECK_THAT(to_text(m), Catch::StartsWith("agree: lar is right about the drawing, 2 segments"));
}

TEST_CASE("the issue has the input, what is expected, what comes out, and how to reproduce it") {
  Minimised m = of_crossing_thirds();
  const std::string text = to_issue(m, {"case.lines", "case.svg"});
  CAPTURE(text);
  CHECK_THAT(text, Catch::StartsWith("# a forgetful engine: face lost with 3 segments\n"));
  for (const char* part :
       {"## Versions", "## Input", "```wkt\nMULTILINESTRING((0 0, 0 1), ", "## Expected",
        "bounded faces", "area ", "## What comes out", "- finding ", "![exact, and the answer",
        "(case.svg)", "plumbline check case.lines --engine forgetful --set times=3"}) {
    CHECK_THAT(text, Catch::Contains(part));
  }
  CHECK_THAT(to_issue(m, {}), !Catch::Contains("!["));
  m.check = check(segments("0 0 2 1  0 1 3 0"), arrange(segments("0 0 2 1  0 1 3 0")),
                  answer_of(without_first(), segments("0 0 2 1  0 1 3 0")));
  CHECK_THAT(to_issue(m, {}),
             Catch::Contains("v2 (1.2, 0.6)\n"));  // x / 2 = 1 - x / 3
}

TEST_CASE("of an engine that has no answer the issue says what it said, and lists no cells") {
  Engine failing = without_first();
  failing.run = [](const SegmentSet&, const Parameters&, std::size_t) -> Answer {
    throw std::runtime_error("TopologyException: <no> `node`");
  };
  const Minimised m = minimised(segments("0 0 1 1  0 1 1 0"), failing);
  const std::string text = to_issue(m, {});
  CAPTURE(text);
  CHECK(m.drawing.segments.size() == 1);
  CHECK_THAT(text, Catch::Contains("- finding 4: TopologyException: <no> `node`\n"));
  CHECK_THAT(text, !Catch::Contains("is missing"));
  CHECK(count(to_svg(m), "//svg") == 1);
}

TEST_CASE("rows of short decimals say the same, or the doubles are written exactly") {
  Minimised m = of_crossing_thirds();
  CHECK(m.holds_in_decimals);
  m.drawing = segments("0.1000000000000000055511151231257827 0 1 1");
  CHECK(to_lines(m) == "0.1,0,1,1\n");
  m.holds_in_decimals = false;
  CHECK(to_lines(m) == "0.1000000000000000055511151231257827,0,1,1\n");
}

TEST_CASE("a picture magnifies what is too close to be seen") {
  CHECK(count(to_svg(of_crossing_thirds()), "//text[starts-with(., 'magnified')]") == 0);
  // Two ends 1e-12 apart, which a radius of 1e-9 makes one.
  const Minimised m =
      minimised(segments("0 0 1 0  1 1e-12 1 1  1 1 0 0"), lar::engine(), {{"radius", 1e-9}});
  REQUIRE(m.outcome.kind == "face invented");
  const std::string svg = to_svg(m);
  CAPTURE(to_text(m));
  CHECK(count(svg, "//text[starts-with(., 'magnified')]") == 1);
  // A panel each above and below, apart from the ground.
  CHECK(count(svg, "//rect[@fill='#ffffff'][@stroke]") == 4);
  // Above all vertices; in the lower left panel both of the ends that are near.
  const std::size_t all = m.check.exact_complex.vertices.size();
  CHECK(count(svg, "//circle[@cx < 800 and @cy < 640 and @fill='#1f2d3a']") == all);
  CHECK(count(svg, "//circle[@cx < 800 and @cy > 640 and @fill='#1f2d3a']") == 2);
  CHECK(count(svg, "//circle[@cx > 800 and @cy > 640 and @fill='#1f2d3a']") == 1);
}

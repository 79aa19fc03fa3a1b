// Where the published svg2lines is wrong and the SVG reader is not: the entries S of
// docs/divergences.md with both results. Published results are those recorded of the original.

#include <catch2/catch.hpp>

#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/inters_stages.hpp"
#include "plumbline/read.hpp"
#include "support/segments.hpp"

using namespace plumbline;

TEST_CASE("S: what svg2lines misreads, the SVG reader reads, maps or names") {
  const std::string line = "<line fill=\"none\" x1=\"0.5\" y1=\"0.5\" x2=\"4.5\" y2=\"8.5\"/>";
  using Row = std::tuple<std::string, std::string, std::string, std::string>;
  const auto [id, elements, of_published, of_repaired] =
      GENERATE_COPY(table<std::string, std::string, std::string, std::string>(
          {Row{"S1 integers divide as integers",
               "<line fill=\"none\" x1=\"0\" y1=\"0\" x2=\"30\" y2=\"10\"/>\n"
               "<line fill=\"none\" x1=\"20\" y1=\"0\" x2=\"10\" y2=\"10\"/>",
               "0 1, 1 1; 0 1, 0 1; ", "0 0, 30 10; 20 0, 10 10; rejected 0"},
           Row{"S2 rectangles need an attribute between y and width",
               "<rect x=\"1\" y=\"2\" width=\"3\" height=\"4\"/>", "SyntaxError",
               "1 2, 4 2; 4 2, 4 6; 4 6, 1 6; 1 6, 1 2; rejected 0"},
           Row{"S3 x1 must not come first",
               line + "\n<line x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4\" stroke=\"none\"/>",
               "0 1, 0.5 0; ", "0.5 0.5, 4.5 8.5; 1 2, 3 4; rejected 0"},
           Row{"S4 one element per text line", line + line, "0 1, 0.5 0; ",
               "0.5 0.5, 4.5 8.5; 0.5 0.5, 4.5 8.5; rejected 0"},
           Row{"S5 one text line per element",
               line + "\n<line fill=\"none\"\n x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4\"/>",
               "0 1, 0.5 0; ", "0.5 0.5, 4.5 8.5; 1 2, 3 4; rejected 0"},
           Row{"S5 transforms are ignored", "<g transform=\"scale(2)\">\n" + line + "\n</g>",
               "0 1, 0.5 0; ", "1 1, 9 17; rejected 0"},
           Row{"S5 other elements are ignored",
               line + "\n<polyline points=\"0,0 1,1\"/>"
                      "\n<text x=\"1\">a</text>",
               "0 1, 0.5 0; ", "0.5 0.5, 4.5 8.5; 0 0, 1 1; rejected 0"},
           Row{"S6 no width",
               "<line fill=\"none\" x1=\"0.5\" y1=\"0\" x2=\"0.5\" y2=\"9\"/>"
               "\n<line fill=\"none\" x1=\"0.5\" y1=\"0\" x2=\"0.5\" y2=\"7\"/>",
               "ZeroDivisionError", "0.5 0, 0.5 9; 0.5 0, 0.5 7; rejected 0"},
           Row{"S7 what is evaluated need not be a number",
               "<rect x=\"1\" y=\"2\" id=\"a\" width=\"3\" height=\"4\" style=\"\"/>",
               "SyntaxError", "1 2, 4 2; 4 2, 4 6; 4 6, 1 6; 1 6, 1 2; rejected 0"}}));
  INFO(id);
  const std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\">\n" + elements + "\n</svg>\n";
  const inters::Vcode vcode(inters::kDecimals);
  std::string found;
  try {
    for (const SegmentD& s : inters::svg_to_lines(svg, true, vcode)) {
      found += shortest_text(s.a.x) + ' ' + shortest_text(s.a.y) + ", " + shortest_text(s.b.x) +
               ' ' + shortest_text(s.b.y) + "; ";
    }
  } catch (const inters::StageFailure& failed) {
    found = failed.failure().error;
  }
  CHECK(found == of_published);
  const SegmentSet read = evaluate(read_svg(svg, "text"));
  std::string repaired;
  for (std::size_t i = 0; i < read.segments.size(); ++i) {
    repaired += to_text(read.segments[i]) + "; ";
  }
  CHECK(repaired + "rejected " + std::to_string(read.rejected.size()) == of_repaired);
}

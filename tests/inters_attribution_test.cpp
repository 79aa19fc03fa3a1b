// Every rule of the catalogue of the published pipeline, docs/divergences.md, on a minimal input:
// the check finds the divergence and names the rule. That the original diverges there is recorded
// (tests/data); what is right follows from the drawings.

#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/engines/inters.hpp"
#include "plumbline/read.hpp"
#include "support/recorded.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

constexpr auto kFaces = inters::Result::LarFromLines;
constexpr auto kAll = inters::Result::AllComponents;
constexpr auto kCells = inters::Result::CellsFromCycles;

/// Compared far below the radius, so that what moves shows, too.
constexpr double kTolerance = 1e-6;

const char* name(inters::Result result) {
  return result == kFaces ? "larFromLines" : result == kAll ? "allComponents" : "cells";
}

Check check_published(const SegmentSet& input, inters::Result result = kFaces,
                      double tolerance = kTolerance) {
  Answer answer = answer_of(inters::engine(), input, {{"result", std::string(name(result))}});
  CheckOptions options;
  options.tolerance = tolerance;
  return check(input, arrange(input), std::move(answer), options);
}

/// "intersect parallel-skipped 3; ...": stages, rules and their findings, of those whose message
/// has the text.
std::string causes(const Check& check, const std::string& about = "") {
  std::map<std::string, std::size_t> counts;
  REQUIRE(check.causes.size() == check.comparison.findings.size());
  for (std::size_t i = 0; i < check.causes.size(); ++i) {
    if (check.comparison.findings[i].message.find(about) == std::string::npos) continue;
    ++counts[check.causes[i].stage + ' ' + check.causes[i].rule];
  }
  std::string text;
  for (const auto& [cause, count] : counts) text += cause + ' ' + std::to_string(count) + "; ";
  return text;
}

/// Segments of the recorded cases, their doubles as they are.
SegmentSet recorded_input(const std::string& name) {
  for (const char* file : {"inters.json", "inters_digests.json"}) {
    const rapidjson::Document cases = recorded(file);
    for (const auto& recorded_case : cases.GetArray()) {
      if (recorded_case["case"].GetString() != name) continue;
      SegmentSet set;
      for (const SegmentD& s : recorded_lines(recorded_case["lines"])) {
        set.add(s.a, s.b, set.add_source({}));
      }
      return set;
    }
  }
  throw std::runtime_error("no case " + name);
}

struct Row {
  std::string id;
  SegmentSet input;
  inters::Result result;
  std::string cause;
};

}  // namespace

TEST_CASE("each rule is found on its minimal input and named") {
  const std::vector<Row> rows{
      {"I1", segments("0 0 2 0  1 0 3 0"), kFaces, "intersect parallel-skipped"},
      {"I2", segments(rectangle(0, 0, 3, 3) + "0 1 2 1  1 1 3 1"), kFaces,
       "intersect parallel-wall"},
      {"I3", segments(rectangle(0, 0, 7, 11) + "0 1 7 1"), kFaces, "intersect parameter-overshoot"},
      {"I5", segments("0.943 0.648 1.343 0.263  1.023 0.571 0.543 0.573"), kFaces,
       "slanted-junction"},
      {"I6", segments("0 0 20 0  6.667 -5 6.667 5"), kFaces, "intersect parameter-rounding"},
      {"I7", recorded_input("scale-orthogonal-8-x0.0001"), kFaces, "absolute-quantum"},
      {"I8", recorded_input("scale-translated-1e9"), kFaces, "quantise twelve-digits"},
      {"I9", segments("0 0.7 0.5 0.7  1 0.7 1.5 0.7  2 0.7 2.5 0.7"), kFaces, "bucket empty-half"},
      {"I9 nothing", segments(""), kFaces, "bucket empty-half"},
      {"I10", segments("0.5 0.5 0.5 0.50000000000000000001  0 0 1 1"), kFaces,
       "simplify point-edge"},
      {"Q1", recorded_input("degenerate-chain-radius"), kFaces, "prune chain-collapse"},
      {"Q2", recorded_input("degenerate-radius-exact"), kFaces, "prune at-radius"},
      {"Q3", segments("0 11 0 0  0 1 7 1"), kFaces, "off-grid-mean"},
      {"Q4", recorded_input("divergence-merge-nontermination"), kFaces, "face walk endless-walk"},
      {"Q5", recorded_input("divergence-merge-euler0"), kFaces, "face walk euler"},
      {"Q6", recorded_input("divergence-merge-partial"), kFaces, "face walk aborted-walk"},
      {"Q7", recorded_input("degenerate-thin-rectangle"), kFaces, "prune thin-part"},
      {"Q9", recorded_input("svgpy-inters-building"), kFaces, "face walk hash-order"},
      {"F1", recorded_input("seed-orthogonal-8"), kFaces, "component filter one-component"},
      {"F2", recorded_input("divergence-most-edges-not-largest"), kFaces,
       "component filter most-edges"},
      {"F3", recorded_input("divergence-hole-dropped"), kFaces, "component filter holes-dropped"},
      {"F4", recorded_input("divergence-two-triangles-vertex-nonterm"), kAll,
       "face walk first-vertex"},
      {"F5", recorded_input("degenerate-single-square"), kAll, "outer face largest-area"},
      {"F5b", recorded_input("degenerate-nested-siblings"), kAll, "outer face exteriors-kept"},
      {"F6",
       segments("0 999.99 0 0  0 0 1000 0  1000 0 1000 1000  1000 1000 0.01 1000  "
                "0.01 1000 0 999.99  0 999.99 0 1000  0 1000 0.01 1000"),
       kFaces, "outer face single-precision-area"},
      {"P1", recorded_input("divergence-lattice-level-vertices"), kCells, "nesting half-crossings"},
      {"P3", segments(rectangle(0, 0, 4, 4) + "0.0003 0.0004 2 1  2 1 1 2  1 2 0.0003 0.0004"),
       kCells, "nesting unrounded-query"},
      {"P4", segments(rectangle(0, 0, 1, 1) + "-2 -2 2 -2  2 -2 3 1  3 1 -2 3  -2 3 -2 -2"), kCells,
       "nesting one-vertex"},
      {"P5", recorded_input("degenerate-squares-touch-vertex-inside"), kCells,
       "nesting on-boundary-level"},
      {"P6", segments(rectangle(0, 0, 1, 1) + "0 0 1 1  1 0 0 1"), kCells,
       "nesting simple-cycles-only"},
      {"P7", recorded_input("degenerate-nested-squares-5"), kCells, "nesting alternate-cells"},
      {"F8", recorded_input("degenerate-cross"), kFaces, "component filter no-cycle"},
  };
  for (const Row& row : rows) {
    const std::string found = causes(check_published(row.input, row.result));
    INFO(row.id << ": " << found);
    CHECK(found.find(row.cause) != std::string::npos);
    CHECK(found.find("nobody") == std::string::npos);
  }
}

TEST_CASE("what svg2lines would misread is found and named") {
  const std::string line = "<line fill=\"none\" x1=\"0.5\" y1=\"0.5\" x2=\"4.5\" y2=\"8.5\"/>";
  const std::vector<std::array<std::string, 3>> rows{
      {"S1",
       "<line fill=\"none\" x1=\"0\" y1=\"0\" x2=\"30\" y2=\"10\"/>\n"
       "<line fill=\"none\" x1=\"20\" y1=\"0\" x2=\"10\" y2=\"10\"/>",
       "parse integer-division 1; "},
      {"S2", line + "\n<rect x=\"1\" y=\"2\" width=\"3\" height=\"4\"/>",
       "parse rect-attribute-order 1; "},
      {"S3", line + "\n<line x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4\" stroke=\"none\"/>",
       "parse line-attribute-order 1; "},
      {"S4", line + "<line fill=\"none\" x1=\"0.5\" y1=\"0.5\" x2=\"4.5\" y2=\"9.5\"/>",
       "parse one-element-per-line 1; "},
      {"S5 text lines", line + "\n<line fill=\"none\"\n x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4\"/>",
       "parse one-line-per-element 1; "},
      {"S5 transforms", "<g transform=\"scale(2)\">\n" + line + "\n</g>",
       "parse one-line-per-element 1; "},
      {"S5 elements", line + "\n<polyline points=\"0,0 1,1\"/>", "parse one-line-per-element 1; "},
      {"S6",
       "<line fill=\"none\" x1=\"0.5\" y1=\"0\" x2=\"0.5\" y2=\"9\"/>\n"
       "<line fill=\"none\" x1=\"0.5\" y1=\"0\" x2=\"0.5\" y2=\"7\"/>",
       "parse zero-extent 1; "},
      {"S7", line + "\n<rect x=\"1\" y=\"2\" id=\"a\" width=\"3\" height=\"4\" style=\"\"/>",
       "parse evaluated-attributes 1; "},
      {"nothing", line, ""},
  };
  for (const auto& [id, elements, cause] : rows) {
    const std::string svg =
        "<svg xmlns=\"http://www.w3.org/2000/svg\">\n" + elements + "\n</svg>\n";
    SegmentSet input = evaluate(read_svg(svg, "text"));
    const Answer answer = answer_of(inters::engine({{}, svg}), input);
    const Check result = check(input, arrange(input), answer);
    INFO(id);
    CHECK(causes(result, "svg2lines") == cause);
  }
}

TEST_CASE("a right drawing gives no finding") {
  for (const std::string& text : {rectangle(0, 0, 1, 1), rectangle(0, 0, 4, 4) + "0 2 4 2  2 0 2 4",
                                  std::string("0 0 1 0  1 0 0 1  0 1 0 0")}) {
    const Check result = check_published(segments(text));
    INFO(causes(result));
    CHECK(result.agree());
  }
}

#include "plumbline/check.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "inputs/families.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/engines/lar.hpp"
#include "plumbline/read.hpp"
#include "plumbline/structure.hpp"
#include "support/engine_checks.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

Check checked(const std::string& text, std::optional<double> radius = {}) {
  return check_lar(segments(text), radius);
}

using StageAndRule = std::pair<std::string, std::string>;

/// The only stage and rule that the findings have.
StageAndRule only_cause(const std::vector<Cause>& causes) {
  REQUIRE_FALSE(causes.empty());
  for (const Cause& cause : causes) {
    CHECK(cause.stage == causes.front().stage);
    CHECK(cause.rule == causes.front().rule);
  }
  return {causes.front().stage, causes.front().rule};
}

/// The only finding about a kind of cell, with its cause.
Explained only_explained(const Check& check, CellKind kind) {
  std::vector<Explained> found;
  for (std::size_t i = 0; i < check.comparison.findings.size(); ++i) {
    if (check.comparison.findings[i].kind == kind) {
      found.push_back({check.comparison.findings[i], check.causes[i]});
    }
  }
  REQUIRE(found.size() == 1);
  return found.front();
}

}  // namespace

TEST_CASE("a drawing whose float result is right has no findings and three equal answers") {
  const Check result = checked("0 0 4 0  4 0 4 4  4 4 0 4  0 4 0 0  1 1 2 1  2 1 2 2  2 2 1 1");
  CHECK(result.agree());
  CHECK(result.conversion.agree());
  CHECK(result.comparison.exact_counts == result.comparison.float_counts);
  CHECK(result.conversion.exact_counts == result.conversion.float_counts);
  CHECK(result.answer.engine == "lar");
}

TEST_CASE("vertices nearer than the radius are merged by pruning") {
  // Two ends 0.01 apart and nothing else within 0.1.
  const Check result = checked("0 0 1 0  1.01 0 2 0", 0.1);
  CHECK(only_cause(result.causes) == StageAndRule("prune", "merged-within-radius"));
  const auto [vertex, cause] = only_explained(result, CellKind::Vertex);
  CHECK(vertex.disagreement == Disagreement::Merged);
  CHECK(cause.round == 1);
  CHECK(cause.confirmed);
  CHECK(cause.remade == false);
  CHECK(cause.distance == Approx(0.01));
  CHECK(cause.advice == "with radius 0.00995 it is not there (tried)");
}

TEST_CASE("with the radius that the advice names there is nothing to find") {
  CHECK(checked("0 0 1 0  1.01 0 2 0", 0.00995).agree());
}

TEST_CASE("where two edges were led to one vertex, the advice is of the nearer one") {
  // Two ceilings 0.01 and 0.02 above the end of a wall, which all meet there, in either order.
  const char* const orders[] = {"0 1 2 1  1 0 1 0.99  0 1.02 2 1",
                                "0 1.02 2 1  1 0 1 0.99  0 1 2 1"};
  const Check first = checked(orders[0], 0.1), second = checked(orders[1], 0.1);
  REQUIRE(first.comparison.findings.size() == second.comparison.findings.size());
  REQUIRE_FALSE(first.agree());
  for (std::size_t i = 0; i < first.comparison.findings.size(); ++i) {
    CHECK(first.causes[i].advice == second.causes[i].advice);
  }
}

TEST_CASE("a chain of near vertices is told from a pair of them") {
  // Feet of walls 0.9 radii apart become one: 4 of them span 2.7 radii (catalogue, Q1).
  const Check result = checked("0 0 0 9  0.09 0 1 9  0.18 0 2 9  0.27 0 3 9", 0.1);
  CHECK(only_cause(result.causes) == StageAndRule("prune", "chain-collapse"));
}

TEST_CASE("an edge led through a vertex beside it is laid to intersecting") {
  // The wall ends 0.01 below the ceiling: a gap for CAD, a T junction within the radius.
  const Check result = checked("0 1 2 1  1 0 1 0.99", 0.1);
  CHECK(only_cause(result.causes) == StageAndRule("intersect", "snapped-to-edge"));
  for (const Cause& cause : result.causes) {
    CHECK(cause.advice == "with radius 0.00995 it is not there (tried)");
  }
}

TEST_CASE("the smallest examples of the catalogue have the rules that they are for") {
  // docs/divergences.md, the repaired pipeline, with the numbers of vertices, edges and components.
  struct Row {
    std::string rule, input;
    std::array<std::size_t, 3> exact_counts, float_counts;
  };
  const std::vector<Row> rows{
      {"merged-within-radius", "0 0 1 0  1.01 0 2 0", {4, 2, 2}, {3, 2, 1}},
      {"chain-collapse", "0 0 0 9  0.09 0 1 9  0.18 0 2 9  0.27 0 3 9", {8, 4, 4}, {5, 4, 1}},
      {"fold-over",
       "0 0 0 9  0.09 0 1 -9  0.18 0 2 -9  0.27 0 3 -9  0.36 0 4 -9  0.45 0 5 -9  0.54 0 6 -9  "
       "0.11 0.2 5 0.2",
       {16, 8, 8},
       {11, 10, 1}},
      {"snapped-to-edge", "0 1 2 1  1 0 1 0.99", {4, 2, 2}, {4, 3, 1}},
      {"missed-meeting", "0 0 10 0  1 0.05 9 -1", {5, 4, 1}, {4, 3, 1}},
  };
  const auto numbers = [](const Counts& counts) {
    return std::array{counts.vertices, counts.edges, counts.components};
  };
  for (const Row& row : rows) {
    INFO(row.rule);
    const Check result = checked(row.input, 0.1);
    CHECK(std::any_of(result.causes.begin(), result.causes.end(),
                      [&](const Cause& cause) { return cause.rule == row.rule; }));
    CHECK(numbers(result.comparison.exact_counts) == row.exact_counts);
    CHECK(numbers(result.comparison.float_counts) == row.float_counts);
  }
}

TEST_CASE("what follows from another finding has its cause") {
  // A quadrangle whose side of 1/100 collapses: one vertex, one edge, one face.
  const Check result = checked("0 0 4 0  4 0 4 0.01  4 0.01 0 4  0 4 0 0", 0.1);
  const auto [face, cause] = only_explained(result, CellKind::Face);
  CHECK(face.because == std::vector<std::size_t>{2});
  CHECK(cause.rule == "merged-within-radius");
}

TEST_CASE("what rounding to doubles changes is laid to parsing where no map has a part in it") {
  // (10.3, 0.1) lies on the wall as authored; the nearest doubles do not.
  const Check result = checked("10 0 10.9 0.3  10.3 0.1 10.5 2");
  CHECK(result.agree());
  CHECK(result.conversion.exact_counts.vertices == 4);
  CHECK(result.conversion.float_counts.vertices == 5);
  CHECK(only_cause(result.conversion_causes).first == "parse");
}

TEST_CASE("what rounding changes after the maps only is laid to transforming") {
  // All numbers are doubles. The map x -> x (1 + 2^-52) + 2^-53 y, exact, leads the foot along with
  // the wall; its coordinates take more than 53 bits.
  Structure structure;
  structure.files = {"test"};
  const Rational ulp = rational_from(0x1p-52);
  Struct root;
  root.body.push_back(Affine(1 + ulp, ulp / 2, ulp / 2, 1 + 3 * ulp, 0, 0));
  Model model;
  model.source.element = "line";
  const auto number = [](double value) { return Number(rational_from(value)); };
  model.segments.push_back({number(0), number(0)}, {number(9), number(3)});
  model.segments.push_back({number(3), number(1)}, {number(5), number(20)});
  root.body.push_back(model);
  structure.structs = {root};
  structure.root = StructId(0);

  CheckOptions options;
  options.parsed = [&] { return evaluate(rounded(structure)); };
  const Check result = check_lar(evaluate(structure), {}, options);
  REQUIRE(result.exact_complex.vertices.size() == 4);
  CHECK(only_cause(result.conversion_causes).first == "transform");
}

TEST_CASE("whoever waits is told which part of a check begins") {
  std::string parts;
  CheckOptions options;
  options.begins = [&](const std::string& part) { parts += part + "; "; };
  check_lar(segments("0 0 1 1  0 1 1 0"), {}, options);
  CHECK(parts == "comparing with float LAR; arranging the drawing in doubles; ");
  parts.clear();
  check_lar(segments("0 0 4 0  4 0 4 0.01  4 0.01 0 4  0 4 0 0"), 0.1, options);
  CHECK(parts.find("looking for the stages that made ") != std::string::npos);
}

TEST_CASE("what a rotation in the file changes is laid to transforming") {
  const Structure drawing = read_svg(
      "<svg xmlns='http://www.w3.org/2000/svg'><g transform='rotate(30)'>"
      "<line x1='0' y1='0' x2='3' y2='0'/><line x1='1' y1='0' x2='1' y2='1'/></g></svg>",
      "text");
  CheckOptions options;
  options.parsed = [&] { return evaluate(rounded(drawing)); };
  const Check result = check_lar(evaluate(drawing), {}, options);
  CHECK(result.conversion.exact_counts.vertices == 4);
  CHECK(result.conversion.float_counts.vertices == 5);
  CHECK(only_cause(result.conversion_causes) == StageAndRule("transform", "transformed-to-double"));
}

TEST_CASE("findings, causes and counts do not depend on the order or direction of the segments") {
  const Check one = checked("0 0 4 0  4 0 4 0.01  4 0.01 0 4  0 4 0 0", 0.1);
  const Check other = checked("0 0 0 4  4 0.01 4 0  0 4 4 0.01  4 0 0 0", 0.1);
  REQUIRE(one.comparison.findings.size() == other.comparison.findings.size());
  for (std::size_t i = 0; i < one.comparison.findings.size(); ++i) {
    const Finding &f = one.comparison.findings[i], &g = other.comparison.findings[i];
    CHECK(f.message == g.message);
    CHECK(one.causes[i].explanation == other.causes[i].explanation);
  }
}

TEST_CASE("every finding of random drawings has a cause with a rule, and a confirmed stage") {
  const std::string family = GENERATE(from_range(inputs::families()));
  CAPTURE(family);
  for (unsigned seed = 0; seed < 1; ++seed) {
    SegmentSet input = inputs::of_family(family, seed);
    const double side = lar::arrange(input).trace.radius / lar::kDefaultRelativeRadius;
    for (const double relative : {0.01, 1e-9}) {
      CAPTURE(seed, relative);
      const Check result = check_lar(input, side * relative);
      REQUIRE(result.causes.size() == result.comparison.findings.size());
      for (std::size_t i = 0; i < result.causes.size(); ++i) {
        INFO(result.comparison.findings[i].message);
        CHECK_FALSE(result.causes[i].rule.empty());
        CHECK(result.causes[i].confirmed);
      }
      CHECK(result.conversion_causes.size() == result.conversion.findings.size());
    }
  }
}

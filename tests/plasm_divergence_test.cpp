// Every rule by which Plasm.jl's arrangement goes wrong, docs/divergences.md, on a minimal input:
// the check finds the divergence and names stage and rule.

#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <set>

#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/engines/lar.hpp"
#include "plumbline/engines/plasm.hpp"
#include "plumbline/pipeline.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

constexpr double kDefault = plasm::kRadius;

Check checked(const SegmentSet& input, double radius = kDefault, double tolerance = 1e-8) {
  CheckOptions options;
  options.tolerance = tolerance;
  return check(input, arrange(input), answer_of(plasm::engine(), input, {{"radius", radius}}),
               options);
}

std::set<std::string> causes(const Check& check) {
  REQUIRE(check.causes.size() == check.comparison.findings.size());
  std::set<std::string> result;
  for (const Cause& cause : check.causes) result.insert(cause.stage + ' ' + cause.rule);
  return result;
}

struct Row {
  std::string drawing;
  double radius;
  std::string counts;  ///< exact, then of Plasm.jl: vertices, edges, bounded faces
  std::string cause;
};

std::string counts(const Check& check) {
  const auto text = [](const Counts& c) {
    return std::to_string(c.vertices) + ' ' + std::to_string(c.edges) + ' ' +
           std::to_string(c.faces - 1);
  };
  return text(check.comparison.exact_counts) + ", " + text(check.comparison.float_counts);
}

}  // namespace

TEST_CASE("each rule of Plasm.jl is found on its minimal input and named") {
  const std::vector<Row> rows{
      {"0 0 1 0  -0.01 -0.00001 0.19 0.00001", kDefault, "5 4 0, 4 2 0",
       "fragment nearly-parallel"},
      {"0 0 2 2  1 1.00005 3 3.00005", kDefault, "4 2 0, 4 3 0", "fragment nearly-collinear"},
      {"0 0 10 1  5 0.55 5 9", 0.01, "4 2 0, 5 4 0", "fragment relative-reach"},
      {"0 3e9 2e9 0  0 1e9 3e9 2e9", kDefault, "5 4 0, 6 4 0", "fragment split-junction"},
      {"0 0 1 0  1.005 0 2 0", 0.01, "4 2 0, 3 2 0", "merge merged-within-radius"},
      {"0 0 0 9  0.009 0 0.009 9  0.018 0 0.018 9  0.027 0 0.027 9", 0.01, "8 4 0, 4 2 0",
       "merge first-come"},
      {"0.008 0.996 -0.004 1.008  -0.004 0 1 1  0.004 5.008 0 0  -0.004 5 0 2", 0.01, "",
       "merge fold-over"},
      {"0 0 4 0  4 0 4 4  4 4 0 0  4 4 6 6", kDefault, "4 4 1, 3 3 1",
       "component filter bridges-dropped"},
      {rectangle(0, 0, 4, 4) + "+ 1 1", kDefault, "5 4 1, 4 4 1",
       "component filter points-dropped"},
      {"0 0 4 4  0 4 4 0", kDefault, "5 4 0, 5 4 0", "component filter no-cycle"},
      {"1.39 0.23 0.62 0.7  1.31 0.21 0.22 0.28  2.46 0.72 0.57 0.34  1.92 1.18 2.15 0.4  "
       "0.6 1.2 2.21 0.19",
       0.1, "", "face walk crossed-walk"},
      {"1.3 2.8 2.1 2.7  0.6 2.9 2.9 0.1  1.3 0.9 0.9 3  3 1.1 0 2.2  1.6 0.5 1.4 1.4", 0.25, "",
       "face walk endless-walk"},
      {"0 2 5 1  5 1 4 2  4 2 0 2  5 2 4 0  0 2 2 1  3 2 3 5", 0.02, "", "outer face no-shell"},
      {rectangle(0, 0, 9, 9) + "3 9 3 3  3 3 9 3  " + rectangle(5, 5, 6, 6), kDefault,
       "11 12 3, 11 12 3", "nesting first-box"},
      {rectangle(0, 0, 9, 9) + "0 0 2 1  2 1 1 2  1 2 0 0", kDefault, "6 7 2, 6 7 2",
       "nesting vertex-on-shell"},
  };
  for (const Row& row : rows) {
    CAPTURE(row.drawing);
    const Check check = checked(segments(row.drawing), row.radius);
    CHECK_FALSE(check.agree());
    std::string all;
    for (const std::string& cause : causes(check)) all += cause + "; ";
    CAPTURE(all);
    CHECK(causes(check).contains(row.cause));
    if (!row.counts.empty()) CHECK(counts(check) == row.counts);
    for (const Cause& cause : check.causes) CHECK_FALSE(cause.explanation.empty());
  }
}

TEST_CASE("float LAR is right where Plasm.jl's omissions are") {
  for (const char* drawing : {"0 0 4 0  4 0 4 4  4 4 0 0  4 4 6 6", "0 0 4 4  0 4 4 0",
                              "0 0 1 0  -0.01 -0.00001 0.19 0.00001"}) {
    const SegmentSet input = segments(drawing);
    CHECK(
        check(input, arrange(input), answer_of(lar::engine(), input, {{"radius", 1e-8}})).agree());
  }
}

TEST_CASE("Plasm.jl's own drawings are right but for edges in no cycle") {
  const std::filesystem::path folder = std::filesystem::path(PLUMBLINE_TEST_DATA) / "plasm";
  const std::map<std::string, bool> has_bridges{
      {"boundarytest2", true}, {"holes", false},           {"howto", true},
      {"interior", false},     {"single_building", false}, {"two_buildings", false}};
  for (const auto& [name, expected] : has_bridges) {
    CAPTURE(name);
    const Check check = checked(evaluate(read(folder / (name + ".svg"))));
    CHECK(check.agree() == !expected);
    const std::set<std::string> bridges{"component filter bridges-dropped"};
    if (expected) CHECK(causes(check) == bridges);
  }
}

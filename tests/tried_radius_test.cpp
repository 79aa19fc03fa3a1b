// What a check advises and what it calls a cause hold: each is tried or recomputed here.

#include <algorithm>
#include <catch2/catch.hpp>

#include "plumbline/check.hpp"
#include "plumbline/output.hpp"
#include "plumbline/read.hpp"
#include "plumbline/structure.hpp"
#include "support/engine_checks.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// Two lines that meet a third one at a small angle, 1/400 beside its end.
const char* const kLater =
    "0 0 2 0  1.5 0.66666666667 1.5 -0.00249999999  0.5 -0.00249999999 2.495 0.0025";
/// Ends 1e-20 apart, and a third one within the radius of both.
const char* const kTwoCauses = "0 1 10 1  0 1.00000000000000000001 10 5  0 1.005 -3 9";

/// Whether a finding is about the same kind of cell and one of the same exact cells.
bool has(const Comparison& comparison, const Finding& finding) {
  return std::any_of(
      comparison.findings.begin(), comparison.findings.end(), [&](const Finding& other) {
        return other.kind == finding.kind &&
               std::find_first_of(other.exact_cells.begin(), other.exact_cells.end(),
                                  finding.exact_cells.begin(),
                                  finding.exact_cells.end()) != other.exact_cells.end();
      });
}

bool names(const std::vector<Cause>& causes, const std::string& stage) {
  return std::any_of(causes.begin(), causes.end(),
                     [&](const Cause& cause) { return cause.stage == stage; });
}

}  // namespace

TEST_CASE("a radius that is advised was tried, where later stages would make the finding again") {
  // An edge is led through a vertex 0.0025 beside it. With 0.0024 it is not, but two vertices
  // 6.27e-6 apart are merged then.
  const Check result = check_lar(segments(kLater), 0.0025);
  REQUIRE_FALSE(result.agree());
  for (std::size_t i = 0; i < result.causes.size(); ++i) {
    const Cause& cause = result.causes[i];
    INFO(result.comparison.findings[i].message);
    REQUIRE(cause.radius_without);
    const Check with_it = check_lar(segments(kLater), *cause.radius_without);
    CHECK_FALSE(has(with_it.comparison, result.comparison.findings[i]));
  }
  CHECK(result.causes[0].radius_without < 6.27e-6);
  CHECK(result.causes[0].advice.find("with radius ") == 0);
}

TEST_CASE("where the least radius that there is joins them too, no radius is advised") {
  // 1e-15 apart, where the least radius is 1.42e-14.
  const Check result = check_lar(segments("0 0 1 0  0 1e-15 -1 1"), 9e-16);
  REQUIRE(result.causes.size() == 1);
  CHECK_FALSE(result.causes[0].radius_without);
  CHECK(result.causes[0].distance == 1e-15);
  CHECK(result.causes[0].advice ==
        "with the least radius that there is, 1.42e-14, it is there too");
}

TEST_CASE("the radius that is advised stands as it was tried") {
  // 0.0158699 to three digits is 0.0159, which would merge them.
  const Check result = check_lar(segments("0 0 1 0  1.0158699 0 2 0"), 0.1);
  REQUIRE(result.causes.size() == 1);
  CHECK(result.causes[0].radius_without == 0.0157);
  CHECK(result.causes[0].advice == "with radius 0.0157 it is not there (tried)");
}

TEST_CASE("a finding that parsing makes a part of names the stage that made the rest, and both") {
  const Check result = check_lar(segments(kTwoCauses));
  REQUIRE(result.causes.size() == 1);
  REQUIRE(result.comparison.findings[0].exact_cells.size() == 3);
  const Cause& cause = result.causes[0];
  CHECK(cause.stage == "prune");
  CHECK(cause.confirmed);
  REQUIRE(cause.with.size() == 1);
  CHECK(cause.with[0].stage == kParse);
  CHECK(cause.with[0].rule == "decimal-to-double");
  // What parsing made stays with any radius.
  CHECK_FALSE(cause.radius_without);
  CHECK(to_text(result).find("prune (also parse)") != std::string::npos);
}

TEST_CASE("a finding that parsing makes alone names parsing alone") {
  const Check result = check_lar(segments("0 1 10 1  0 1.00000000000000000001 10 5"));
  REQUIRE(result.causes.size() == 1);
  CHECK(result.causes[0].stage == kParse);
  CHECK(result.causes[0].with.empty());
}

TEST_CASE("the drawing's digits are to blame only for what they make, not for all at their place") {
  // With a radius of 30 all is one vertex, so far away that the others are missing; joining what
  // the digits leave open would make one vertex of two.
  const Structure drawing = read_lines("0,1,10,1\n0,1.00000000000000000001,10,5\n", "text");
  const Check result = check_lar(evaluate(drawing), 30);
  REQUIRE(result.drift.places == 1);
  CHECK(result.own_findings() == 0);
  for (const Cause& cause : result.causes) CHECK(cause.stage == "prune");
}

TEST_CASE("a finding names the stages of what it follows from") {
  // A triangle whose foot is cut off by 1e-20, which parsing joins, and whose corner the radius
  // joins to another line: the face is reshaped by both.
  const Check result = check_lar(
      segments("0 0 4 0  4 0 4 4  4 4 0 0.00000000000000000001  0 0 0 0.00000000000000000001  "
               "4.01 4.01 9 9"),
      0.1);
  for (std::size_t i = 0; i < result.causes.size(); ++i) {
    const Cause& cause = result.causes[i];
    INFO(result.comparison.findings[i].message);
    for (const std::size_t number : result.comparison.findings[i].because) {
      const std::string& stage = result.causes[number - 1].stage;
      CHECK((cause.stage == stage || names(cause.with, stage)));
    }
  }
}

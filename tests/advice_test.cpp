#include <algorithm>
#include <catch2/catch.hpp>
#include <pugixml.hpp>

#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/output.hpp"
#include "plumbline/read.hpp"
#include "support/engine_checks.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

Check advised(const SegmentSet& input, const AdviceOptions& options = {}) {
  return plumbline::advised(check_lar(input), options);
}

/// "wrong 0.1, right 0.5": what `check` says for each radius that was tried.
std::string verdicts(const Check& advice) {
  std::string text;
  for (const TriedRadius& trial : advice.right_radii->tried) {
    const bool is_right = check_lar(advice.input, trial.radius).agree();
    text += (text.empty() ? "" : ", ") + std::string(is_right ? "right " : "wrong ") +
            shortest_text(trial.radius);
  }
  return text;
}
std::string verdicts(const std::vector<TriedRadius>& tried) {
  std::string text;
  for (const TriedRadius& trial : tried) {
    text += (text.empty() ? "" : ", ") + std::string(trial.is_right ? "right " : "wrong ") +
            shortest_text(trial.radius);
  }
  return text;
}

}  // namespace

TEST_CASE("right radii end where the ladder begins") {
  const Check advice = advised(evaluate(read(PLUMBLINE_EXAMPLES "/office-plan.svg")));
  REQUIRE(advice.right_radii);
  CHECK_FALSE(advice.right_radii->empty());
  const double first = nearest_sqrt(advice.ladder->steps.front().squared_radius);
  CHECK(advice.right_radii->largest < first);
  CHECK(advice.right_radii->largest > 0.99 * first);
  CHECK(advice.right_radii->tried.back().radius > first);
  CHECK_FALSE(advice.right_radii->tried.back().is_right);
}

TEST_CASE("what was tried is what check says") {
  const Check advice = advised(segments("0 0 10 0  5 1/3 5 3  9 2 9 7/4  0 0 3 7"));
  CHECK(verdicts(advice) == verdicts(advice.right_radii->tried));
  CHECK(advice.right_radii->tried.size() >= 6);
  CHECK(advice.right_radii->largest > 0.24);
  CHECK(advice.right_radii->largest < 0.25);
}

TEST_CASE("where rounding takes a point apart, radii are right from where they join it") {
  // Three lines through (1/3, 1/3) at angles of some 1e-4: doubles let them meet in three places,
  // some 1e-16 / 1e-4 apart, and the least radius of 2^-46 does not join these.
  const Check advice =
      advised(segments("0 0 1 1  0 -1/30000 1 30002/30000  0 -1/10000 1 10002/10000"));
  CHECK(summary(advice.exact_complex) == "V 7 E 6 F 1 C 1 antennas 6");
  const RightRadii& radii = *advice.right_radii;
  INFO(verdicts(radii.tried));
  CHECK(verdicts(advice) == verdicts(radii.tried));
  CHECK_FALSE(radii.tried.front().is_right);
  CHECK(radii.least > 0x1p-46);
  CHECK(radii.least < 1e-9);
  CHECK(radii.largest > 2e-5);
  CHECK(radii.largest < 1.0 / 30000);
}

TEST_CASE("a terminal shows right radii in the second line") {
  const Check advice = advised(segments("0 0 10 0  5 1/3 5 3  9 2 9 7/4"));
  const std::string text = to_text(advice);
  INFO(text);
  const RightRadii& radii = *advice.right_radii;
  REQUIRE(radii.advised);
  CHECK(text.find("agree\nfloat LAR is right with --radius " + shortest_text(*radii.advised) +
                  ", and with all tried from ") == 0);
  CHECK(std::any_of(radii.tried.begin(), radii.tried.end(), [&](const TriedRadius& t) {
    return t.radius == *radii.advised && t.is_right;
  }));
}

TEST_CASE("a plot has a line for each number of cells, and a band of right radii") {
  const Check advice = advised(segments(rectangle(0, 0, 3, 2)));
  pugi::xml_document svg, without;
  REQUIRE(svg.load_string(to_svg(*advice.ladder, advice.right_radii).c_str()));
  REQUIRE(without.load_string(to_svg(*advice.ladder).c_str()));
  CHECK(svg.select_node("//rect/title").node().text().as_string() ==
        "float LAR is right with every radius tried from " +
            shortest_text(advice.right_radii->least) + " to " +
            shortest_text(advice.right_radii->largest));
  CHECK(without.select_nodes("//rect/title").empty());
  // A start, and two steps each.
  std::size_t plots = 0;
  for (const auto& path : svg.select_nodes("//path[@fill='none']")) {
    const std::string way = path.node().attribute("d").value();
    CHECK(std::count(way.begin(), way.end(), 'V') == 2);
    ++plots;
  }
  CHECK(plots == 3);
  CHECK(without.load_string(to_svg(tolerance_ladder(arrange(segments("")))).c_str()));
}

TEST_CASE("no radius is right where features are smaller than rounding") {
  const Check advice = advised(segments("0 0 1 0  0 1e-17 1 1e-17"));
  CHECK(advice.right_radii->empty());
  CHECK(to_text(advice).find("No radius is right for float LAR, of ") != std::string::npos);
}

TEST_CASE("the number of runs is bounded, and they can be cancelled") {
  const SegmentSet input = segments(rectangle(0, 0, 3, 2));
  AdviceOptions options;
  options.max_runs = 2;
  std::size_t runs = 0;
  options.progress = [&](double) { return ++runs > 0; };
  CHECK(advised(input, options).right_radii->tried.size() == 3);  // and that of the answer
  CHECK(runs == 2);
  options.progress = [](double) { return false; };
  CHECK_THROWS_AS(advised(input, options), Error);
}

TEST_CASE("radii are right within the tolerance that the check was made with") {
  const SegmentSet input =
      segments("500000 5000000 500003 5000001  500000 5000001 500003 5000000.1");
  CheckOptions options;
  options.tolerance = 1e-10;
  const Check result =
      advised(check(input, arrange(input), answer_of(lar::engine(), input), options));
  REQUIRE_FALSE(result.agree());
  const double radius = *result.answer.radius;
  const RightRadii& radii = *result.right_radii;
  INFO(verdicts(radii.tried));
  CHECK(std::any_of(radii.tried.begin(), radii.tried.end(),
                    [&](const TriedRadius& t) { return t.radius == radius && !t.is_right; }));
  CHECK((radii.empty() || radius < radii.least || radius > radii.largest));
}

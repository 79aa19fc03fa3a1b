// What a file's own digits leave open.

#include <algorithm>
#include <catch2/catch.hpp>

#include "plumbline/arrange.hpp"
#include "plumbline/engines/lar.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"
#include "plumbline/read.hpp"
#include "support/engine_checks.hpp"

using namespace plumbline;

namespace {

ReadOptions shortest() {
  ReadOptions options;
  options.shortest_decimals = true;
  return options;
}

SegmentSet lines(const std::string& text) { return evaluate(read_lines(text, "a.lines")); }
SegmentSet svg(const std::string& elements, const ReadOptions& options = {}) {
  return evaluate(
      read_svg("<svg xmlns='http://www.w3.org/2000/svg'>" + elements + "</svg>", "a.svg", options));
}
Drift drift_of(const SegmentSet& input) { return drift(input, arrange(input)); }

std::size_t count(const Check& check, const std::string& stage) {
  return static_cast<std::size_t>(
      std::count_if(check.causes.begin(), check.causes.end(),
                    [&](const Cause& cause) { return cause.stage == stage; }));
}
std::string first_line(const Check& check) {
  const std::string text = to_text(check, 0);
  return text.substr(0, text.find('\n'));
}

// A wall that a program drew by its middle and its length, and another by its corners.
const std::string kApartment =
    "<g transform='matrix(1.8 0 0 1.8 540 540)'>"
    "<g transform='matrix(1 0 0 1 103.16 -52.33)'><path transform='translate(-402.57, -112.08)' "
    "d='M 384.79 88.91 L 420.34000000000003 88.91 L 420.34000000000003 135.24 L "
    "385.20000000000005 135.24 L 384.80000000000007 88.91000000000001 Z'/></g>"
    "<g transform='matrix(1 0 0 1 120.93 -53.14)'>"
    "<line x1='0' y1='-23.980000000000004' x2='0' y2='23.980000000000004'/></g></g>";

}  // namespace

TEST_CASE("a drawing of short numbers has no drift, however near its lines are") {
  const SegmentSet input = lines("0,0,4,0\n0,0.00000000001,4,0.00000000001\n");
  CHECK(input.rounding.empty());
  CHECK(drift_of(input).places == 0);
}

TEST_CASE("places are counted that printed doubles do not tell apart") {
  const Drift found =
      drift_of(lines("0,0,420.34,0\n420.34000000000003,0,420.34000000000003,9\n1,1,2,1\n"));
  CHECK(found.places == 1);
  CHECK(found.largest == Approx(3e-14));
  CHECK(to_text(found) == "printed doubles: 1 place, at most 3e-14 apart");
}

TEST_CASE("eight units in the last place of the largest coordinate are drift, more are not") {
  // 8 x 2^-52 x 512 = 9.09e-13
  const auto places = [](const std::string& x) {
    return drift_of(lines("0,0,512,0\n0,3,500,3\n" + x + ",3," + x + ",9\n")).places;
  };
  CHECK(places("500.0000000000008") == 1);
  CHECK(places("500.0000000000012") == 0);
}

TEST_CASE("a vertex beside an edge is a place") {
  const Drift found = drift_of(lines("0,1,9,1\n4,1.0000000000000002,4,5\n"));
  CHECK(found.places == 1);
  CHECK(found.beside.size() == 1);
}

TEST_CASE("what lies far away does not make everything drift") {
  std::string rows;
  for (int i = 0; i < 20; ++i) rows += std::to_string(i) + ",0," + std::to_string(i) + ".5,1\n";
  rows += "3.0000000000001,0,9.0000000000001,7\n";
  CHECK(drift_of(lines(rows)).places == 0);
  CHECK(drift_of(lines(rows + "1e15,1e15,1e15,2e15\n")).places == 0);
}

TEST_CASE("drift grows with the map and with what the ledger says of angles") {
  const std::string gap = "<path d='M 0 0 L 1 0 M 1.0000000000000002 0 L 1.0000000000000002 1'/>";
  const double bound = drift_of(svg(gap)).bound;
  CHECK(drift_of(svg("<g transform='scale(64)'>" + gap + "</g>")).bound == Approx(64 * bound));
  // sin 30 = 0.5 is rational, cos 30 is not.
  const std::string turned =
      "<path transform='rotate(30)' d='M 0 0 L 100 0'/><path d='M 86.602540378 50 V 200'/>";
  ReadOptions coarse;
  coarse.angle_bound = 1e-6;
  CHECK(drift_of(svg(turned)).places == 0);
  CHECK(drift_of(svg(turned, coarse)).places == 1);
}

TEST_CASE("drift does not depend on the order and direction of segments") {
  const SegmentSet input = svg(kApartment);
  SegmentSet turned;
  turned.add_file("a");
  const SourceId source = turned.add_source({});
  for (std::size_t i = input.segments.size(); i-- > 0;) {
    turned.add({input.segments[i].b, input.segments[i].a}, source);
    turned.rounding.push_back(input.rounding[i]);
  }
  const Drift a = drift_of(input), b = drift_of(turned);
  CHECK(a.places == b.places);
  CHECK(a.largest == b.largest);
  CHECK(a.stands_for == b.stands_for);
  CHECK(a.beside == b.beside);
}

TEST_CASE("findings within the file's own drift are never blamed on float LAR") {
  const Check result = check_lar(svg(kApartment), 1e-8);
  REQUIRE(result.drift.places > 0);
  CHECK(result.drift.largest < 1e-13);
  CHECK_FALSE(result.agree());
  CHECK(result.own_findings() == result.comparison.findings.size());
  CHECK(first_line(result) ==
        "agree but for the file's own drift: " + std::to_string(result.own_findings()) +
            " findings in " + std::to_string(result.groups.size()) + " group" +
            (result.groups.size() == 1 ? "" : "s"));
}

TEST_CASE("with short decimals there is nothing to find") {
  const Check result = check_lar(svg(kApartment, shortest()), 1e-8);
  CHECK(result.agree());
  CHECK(result.drift.places == 0);
}

TEST_CASE("what float LAR merged beyond the drift stays its own") {
  // Two ends a billionth apart, and, elsewhere, one place of the file.
  const Check result = check_lar(lines("0,5,1,5\n1.000000001,5,2,5\n0,0,420.34,0\n"
                                       "420.34000000000003,0,420.34000000000003,9\n"),
                                 1e-8);
  CHECK(result.drift.places == 1);
  CHECK(count(result, kDrawing) > 0);
  CHECK(count(result, "prune") > 0);
  CHECK(count(result, kDrawing) + count(result, "prune") == result.causes.size());
  CHECK(first_line(result).starts_with("disagree: "));
  CHECK(first_line(result).ends_with("of them the file's own drift"));
}

TEST_CASE("a place that float LAR merged with something else is not the file's own") {
  const Check result = check_lar(lines("0,0,420.34,0\n420.340000001,1,420.340000001,0\n"
                                       "420.34000000000003,0,420.34000000000003,-9\n"),
                                 1e-8);
  CHECK(result.drift.places == 1);
  REQUIRE_FALSE(result.causes.empty());
  const Finding& first = result.comparison.findings.front();
  CHECK(first.kind == CellKind::Vertex);
  CHECK(first.exact_cells.size() == 3);
  CHECK(result.causes.front().stage != kDrawing);
}

TEST_CASE("a radius whose findings are the file's own alone is right") {
  const Check result = advised(check_lar(svg(kApartment), 1e-8));
  REQUIRE(result.own_findings() > 0);
  REQUIRE(result.right_radii);
  CHECK_FALSE(result.right_radii->empty());
  CHECK(result.right_radii->least <= 1e-8);
  CHECK(result.right_radii->largest >= 1e-8);
}

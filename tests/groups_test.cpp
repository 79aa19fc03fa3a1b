#include "plumbline/check/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "inputs/families.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/engines/lar.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"
#include "support/checks.hpp"

using namespace plumbline;

namespace {

/// Three rooms of 2 x 4 side by side.
const std::string kRooms = rectangle(0, 0, 6, 4) + "2 0 2 4  4 0 4 4  ";

struct Held {
  ExactComplex exact_complex, answer;
  Comparison comparison;
  std::vector<FindingGroup> groups;
};

/// What another drawing looks like where this one was meant.
Held held(const std::string& drawing, const std::string& other, double tolerance = 1e-9) {
  Held result{arrange(segments(drawing)), arrange(segments(other)), {}, {}};
  result.comparison = compare(result.exact_complex, result.answer, tolerance);
  result.groups =
      group_findings(result.comparison, {}, result.exact_complex, nearest(result.answer));
  return result;
}

std::vector<std::size_t> all_numbers(const std::vector<FindingGroup>& groups) {
  std::vector<std::size_t> numbers;
  for (const FindingGroup& group : groups) {
    numbers.insert(numbers.end(), group.findings.begin(), group.findings.end());
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

std::vector<std::size_t> numbers_to(std::size_t n) {
  std::vector<std::size_t> numbers(n);
  std::iota(numbers.begin(), numbers.end(), 1);
  return numbers;
}

Check checked_with(const std::string& drawing, double radius) {
  const SegmentSet input = segments(drawing);
  const Engine engine = lar::engine();
  const Parameters parameters{{"radius", radius}};
  return check(input, arrange(input), answer_of(engine, input, parameters, 1));
}

}  // namespace

TEST_CASE("a wall that is missing joins two rooms: one group, with their areas") {
  const Held rooms = held(kRooms, rectangle(0, 0, 6, 4) + "4 0 4 4");
  REQUIRE(rooms.groups.size() == 1);
  const FindingGroup& group = rooms.groups[0];
  CHECK(group.findings == numbers_to(rooms.comparison.findings.size()));
  REQUIRE(group.faces.size() == 1);
  CHECK(group.faces[0].change == FaceChange::Joined);
  CHECK(group.faces[0].areas == std::vector<double>{8, 8});
}

TEST_CASE("an outer wall that is missing opens a room") {
  const Held rooms = held(kRooms, "0 0 6 0  6 0 6 4  6 4 2 4  0 4 0 0  2 0 2 4  4 0 4 4");
  REQUIRE(rooms.groups.size() == 1);
  REQUIRE(rooms.groups[0].faces.size() == 1);
  CHECK(rooms.groups[0].faces[0].change == FaceChange::Opened);
  CHECK(rooms.groups[0].faces[0].areas == std::vector<double>{8});
  CHECK(rooms.groups[0].area == 8);
}

TEST_CASE("a wall too many parts a room, or closes one that is open") {
  const Held parted = held(kRooms, kRooms + "1 0 1 4");
  REQUIRE(parted.groups.size() == 1);
  CHECK(parted.groups[0].faces.at(0).change == FaceChange::Parted);
  const Held closed = held("0 0 2 0  2 0 2 2  2 2 0 2", "0 0 2 0  2 0 2 2  2 2 0 2  0 2 0 0");
  REQUIRE(closed.groups.size() == 1);
  CHECK(closed.groups[0].faces.at(0).change == FaceChange::Closed);
  CHECK(closed.groups[0].faces.at(0).areas == std::vector<double>{4});
}

TEST_CASE("what happens in two places is two groups, that with the larger area first") {
  const std::string far = rectangle(100, 0, 120, 10) + "110 0 110 10";
  const Held both =
      held(kRooms + far, rectangle(0, 0, 6, 4) + "4 0 4 4  " + rectangle(100, 0, 120, 10));
  REQUIRE(both.groups.size() == 2);
  CHECK(both.groups[0].faces.at(0).areas == std::vector<double>{100, 100});
  CHECK(both.groups[1].faces.at(0).areas == std::vector<double>{8, 8});
  CHECK(both.groups[0].low == PointD{100, 0});
  CHECK(both.groups[0].high == PointD{120, 10});
}

TEST_CASE("a thin face that collapses is lost, though its place is outside") {
  const Check check =
      checked_with(rectangle(0, 0, 4, 4) + "6 0 6.01 0  6.01 0 6.01 4  6.01 4 6 4  6 4 6 0", 0.1);
  REQUIRE(check.groups.size() == 1);
  CHECK(check.groups[0].faces.at(0).change == FaceChange::Lost);
}

TEST_CASE("an answer elsewhere is one group, whatever its findings are") {
  CHECK(held(kRooms, rectangle(10, 0, 16, 4) + "12 0 12 4  14 0 14 4").groups.size() == 1);
  CHECK(held(kRooms, "").groups.size() == 1);
}

TEST_CASE("each finding is in one group, the first of which is a reason and not a consequence") {
  std::size_t groups = 0;
  for (const std::string& family : inputs::families()) {
    for (unsigned seed = 301; seed <= 304; ++seed) {
      INFO(family << ' ' << seed);
      const SegmentSet input = inputs::of_family(family, seed);
      const ExactComplex exact_complex = arrange(input);
      const FeatureSize size =
          exact_complex.edge_count() > 0 ? feature_size(exact_complex) : FeatureSize{};
      const double radius = 3 * nearest_sqrt(size.squared_vertex_vertex);
      const Check result =
          check(input, exact_complex, answer_of(lar::engine(), input, {{"radius", radius}}, 1));
      CHECK(all_numbers(result.groups) == numbers_to(result.comparison.findings.size()));
      groups += result.groups.size();
      for (const FindingGroup& group : result.groups) {
        CHECK(std::binary_search(group.findings.begin(), group.findings.end(), group.lead));
        for (const std::size_t reason : result.comparison.findings[group.lead - 1].because) {
          CHECK(!std::binary_search(group.findings.begin(), group.findings.end(), reason));
        }
      }
    }
  }
  CHECK(groups > 100);
}

TEST_CASE("groups do not depend on the order of the input") {
  const std::string first = "0 0 4 0  4 0 4 4  4 4 0 4  0 4 0 0  2 0 2 4  2.01 0 2.01 4  ";
  const std::string second = "2.01 0 2.01 4  2 0 2 4  0 4 0 0  4 4 0 4  4 0 4 4  0 0 4 0  ";
  const Check a = checked_with(first, 0.1), b = checked_with(second, 0.1);
  REQUIRE(a.groups.size() == b.groups.size());
  REQUIRE(a.groups.size() > 0);
  for (std::size_t i = 0; i < a.groups.size(); ++i) {
    CHECK(a.groups[i].findings == b.groups[i].findings);
    CHECK(a.groups[i].lead == b.groups[i].lead);
    CHECK(a.groups[i].area == b.groups[i].area);
  }
}

TEST_CASE("the first screen has at most 40 lines, however many findings there are") {
  std::string drawing;
  for (int i = 0; i < 60; ++i) {
    const int x = 10 * i;
    drawing += rectangle(x, 0, x + 4, 4) + fmt::format("{}.01 0 {} 1  ", x + 4, x + 6);
  }
  const Check many = checked_with(drawing, 0.1);
  REQUIRE(many.groups.size() > 50);
  const std::string text = to_text(many);
  CHECK(std::count(text.begin(), text.end(), '\n') <= 40);
  CHECK(text.find("The radius 0.1 is larger than details of the drawing: 120 of its 360 vertices "
                  "are nearer to another one.") != std::string::npos);
}

// Coverages: what is wrong with them, and clean ones.

#include "plumbline/coverage.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <random>

#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "plumbline/rings.hpp"

using namespace plumbline;

namespace {

using Corners = std::vector<std::array<int, 2>>;
using Points = std::vector<Point>;

/// Adds polygons as readers do.
class PolygonLayer {
 public:
  SegmentSet input;

  void add(const Points& corners, RingRole role) {
    input.rings.push_back({static_cast<std::uint32_t>(input.segments.size()),
                           static_cast<std::uint32_t>(corners.size()), role});
    const SourceId source = input.add_source({});
    for (std::size_t i = 0; i < corners.size(); ++i) {
      input.add(Segment{corners[i], corners[(i + 1) % corners.size()]}, source);
    }
  }
  void add(const Corners& corners, RingRole role = RingRole::Polygon) {
    Points points;
    for (const auto& [x, y] : corners) points.push_back({x, y});
    add(points, role);
  }
};

SegmentSet layer(const std::vector<Corners>& polygons) {
  PolygonLayer result;
  for (const Corners& corners : polygons) result.add(corners);
  return result.input;
}

Corners rectangle(int x0, int y0, int x1, int y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

struct Checked {
  Coverage coverage;
  std::vector<CoverageFault> faults;

  explicit Checked(const SegmentSet& input)
      : coverage(plumbline::coverage(input, arrange(input))),
        faults(plumbline::faults(coverage, input)) {}
};

/// "overlap 0 1 area 2 width 1" or "unmatched vertex 0 1 at 1 1", a line each.
std::string text_of(const std::vector<CoverageFault>& faults) {
  std::string text;
  for (const CoverageFault& fault : faults) {
    text += to_text(fault.kind);
    for (const RegionId r : fault.polygons) text += ' ' + std::to_string(std::size_t{r});
    text += fault.kind == CoverageFaultKind::UnmatchedVertex ? " at " + to_text(fault.at)
                                                             : " area " + exact_text(fault.area);
    text += '\n';
  }
  return text;
}
std::string faults_of(const SegmentSet& input) { return text_of(Checked(input).faults); }

CleanCoverage clean(const SegmentSet& input, const CleanOptions& options = {}) {
  const Checked checked(input);
  return cleaned(checked.coverage, input, checked.faults, options);
}
std::vector<Rational> areas_of(const CleanCoverage& clean) { return polygon_areas(clean.coverage); }

/// The drawing that the polygons of a coverage are, which have the same numbers where none
/// vanished.
SegmentSet drawn(const Coverage& coverage) {
  PolygonLayer result;
  const auto places = [&](std::span<const VertexId> ring) {
    Points points;
    for (const VertexId v : ring) points.push_back(coverage.complex.vertices[v]);
    return points;
  };
  for (const auto& parts :
       owned_polygons(coverage.complex, coverage.owners, coverage.polygons.size())) {
    for (const FacePolygon& part : parts) {
      result.add(places(part.outer), &part == parts.data() ? RingRole::Polygon : RingRole::Part);
      for (std::size_t h = 0; h < part.holes.size(); ++h) {
        result.add(places(part.holes[h]), RingRole::Hole);
      }
    }
  }
  return result.input;
}

Rational sum(const std::vector<Rational>& areas) {
  Rational result = 0;
  for (const Rational& area : areas) result += area;
  return result;
}

/// What polygons of a drawing cover together.
Rational covered(const Coverage& coverage) {
  const std::vector<Rational> areas = face_areas(coverage.complex);
  Rational result = 0;
  for (std::size_t f = 0; f < areas.size(); ++f) {
    if (!coverage.owners[f].empty()) result += areas[f];
  }
  return result;
}

std::vector<Corners> random_triangles(std::mt19937& random, int count) {
  std::uniform_int_distribution<int> place(-1000, 1000);
  std::vector<Corners> result;
  while (result.size() < static_cast<std::size_t>(count)) {
    Corners c;
    for (int i = 0; i < 3; ++i) c.push_back({place(random), place(random)});
    const int twice =
        (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0]);
    if (twice != 0) result.push_back(c);
  }
  return result;
}

const SegmentSet kTwoTriangles =
    layer({{{1, 0}, {1, 1}, {1, 3}, {4, 0}}, {{0, 4}, {1, 3}, {1, 0}}});

}  // namespace

TEST_CASE("neighbours that share their vertices are a coverage") {
  CHECK(faults_of(layer({rectangle(0, 0, 2, 2), rectangle(2, 0, 4, 2)})).empty());
  CHECK(faults_of(layer({rectangle(0, 0, 2, 2), rectangle(2, 2, 4, 4)})).empty());
  CHECK(faults_of(layer({})).empty());
}

TEST_CASE("GEOS #1525: a vertex that one of two neighbours lacks is all that is wrong") {
  CHECK(faults_of(kTwoTriangles) == "unmatched vertex 1 0 at 1 1\n");
  for (const auto policy : {CoveragePolicy::LongestBorder, CoveragePolicy::Largest,
                            CoveragePolicy::Smallest, CoveragePolicy::First}) {
    CleanOptions options;
    options.policy = policy;
    const CleanCoverage result = clean(kTwoTriangles, options);
    CHECK(areas_of(result) == std::vector<Rational>{Rational(9, 2), Rational(3, 2)});
    CHECK(result.changes.empty());
    CHECK(faults_of(drawn(result.coverage)).empty());
  }
}

TEST_CASE("overlaps and gaps have exact areas and their polygons") {
  const SegmentSet overlap = layer({rectangle(0, 0, 3, 2), rectangle(2, 0, 4, 2)});
  CHECK(faults_of(overlap) ==
        "overlap 0 1 area 2\nunmatched vertex 0 1 at 2 0\nunmatched vertex 0 1 at 2 2\n"
        "unmatched vertex 1 0 at 3 0\nunmatched vertex 1 0 at 3 2\n");
  const SegmentSet ring = layer(
      {rectangle(0, 0, 4, 1), rectangle(3, 1, 4, 4), rectangle(0, 3, 3, 4), rectangle(0, 1, 1, 3)});
  const Checked checked(ring);
  REQUIRE(!checked.faults.empty());
  CHECK(text_of({checked.faults.front()}) == "gap 0 1 2 3 area 4\n");
  CHECK(checked.faults.front().width == Approx(2).epsilon(0.02));
  CHECK(checked.faults.front().at == Point{2, 2});
  // A slit that leads outside is none.
  CHECK(faults_of(layer({rectangle(0, 0, 2, 2), rectangle(3, 0, 5, 2)})).empty());
  CHECK(faults_of(layer({rectangle(0, 0, 2, 2), rectangle(0, 0, 2, 2)})) == "overlap 0 1 area 4\n");
}

TEST_CASE("the width of a sliver is that of the largest circle in it, far away, too") {
  const int far = 5'000'000;
  PolygonLayer drawing;
  const Rational thin(1, 1'000'000);
  drawing.add(rectangle(far, 0, far + 10, 10));
  drawing.add(Points{{far + 10 - thin, 0}, {far + 20, 0}, {far + 20, 10}, {far + 10 - thin, 10}},
              RingRole::Polygon);
  const Checked checked(drawing.input);
  CHECK(checked.faults.front().area == thin * 10);
  CHECK(checked.faults.front().width == Approx(1e-6).epsilon(0.05));
  // A triangle of sides 3, 4, 5 has a circle of radius 1.
  const Checked triangle(layer({{{0, 0}, {4, 0}, {0, 3}}, {{0, 0}, {4, 0}, {0, 3}}}));
  CHECK(triangle.faults.front().width == Approx(2));
}

TEST_CASE("an overlap goes to one of its polygons by the policy") {
  // The overlap [2, 3] x [0, 2] has a border of 3 with the first, of 2 with the second, and of 1
  // with the third, which is below.
  const SegmentSet input =
      layer({rectangle(0, 0, 3, 3), rectangle(2, 0, 9, 2), rectangle(2, -1, 3, 0)});
  const auto areas = [&](CoveragePolicy policy) {
    CleanOptions options;
    options.policy = policy;
    return areas_of(clean(input, options));
  };
  CHECK(areas(CoveragePolicy::LongestBorder) == std::vector<Rational>{9, 12, 1});
  CHECK(areas(CoveragePolicy::Largest) == std::vector<Rational>{7, 14, 1});
  CHECK(areas(CoveragePolicy::Smallest) == std::vector<Rational>{9, 12, 1});
  CHECK(areas(CoveragePolicy::First) == std::vector<Rational>{9, 12, 1});
}

TEST_CASE("a gap goes to the neighbour with the longest border, if it is within the limit") {
  // Around [1, 4] x [1, 2]; the first one is below it.
  const SegmentSet input = layer(
      {rectangle(0, 0, 5, 1), rectangle(4, 1, 5, 3), rectangle(0, 2, 4, 3), rectangle(0, 1, 1, 2)});
  const auto areas = [&](const CleanOptions& options) { return areas_of(clean(input, options)); };
  CHECK(areas({}) == std::vector<Rational>{8, 2, 4, 1});
  CleanOptions options;
  options.gaps.width = Rational(9, 10);
  CHECK(areas(options) == std::vector<Rational>{5, 2, 4, 1});
  options.gaps.width = Rational(11, 10);
  CHECK(areas(options) == std::vector<Rational>{8, 2, 4, 1});
  options.gaps.area = 2;
  CHECK(areas(options) == std::vector<Rational>{5, 2, 4, 1});
  CHECK(clean(input, options).changes.empty());
  options.gaps = {};
  options.policy = CoveragePolicy::Smallest;
  CHECK(areas(options) == std::vector<Rational>{5, 2, 4, 4});
}

TEST_CASE("a gap beside an overlap sees who has it now") {
  // The gap [2, 4] x [0, 1] is enclosed by two frames that overlap right of it.
  PolygonLayer drawing;
  drawing.add(rectangle(0, -1, 6, 2));
  drawing.add(rectangle(2, 0, 4, 1), RingRole::Hole);
  drawing.add(rectangle(4, 0, 9, 1));
  CleanOptions options;
  options.policy = CoveragePolicy::Largest;
  const CleanCoverage result = clean(drawing.input, options);
  REQUIRE(result.changes.size() == 2);
  CHECK(result.changes[0].fault.kind == CoverageFaultKind::Overlap);
  CHECK(result.changes[1].fault.kind == CoverageFaultKind::Gap);
  CHECK(areas_of(result) == std::vector<Rational>{18, 3});
}

TEST_CASE("a polygon that lies in another one vanishes by some policies, which is told") {
  const SegmentSet input = layer({rectangle(0, 0, 9, 9), rectangle(3, 3, 5, 5)});
  CHECK(clean(input).vanished == std::vector<RegionId>{RegionId(1)});
  CHECK(areas_of(clean(input)) == std::vector<Rational>{81, 0});
  CleanOptions options;
  options.policy = CoveragePolicy::Smallest;
  const CleanCoverage result = clean(input, options);
  CHECK(result.vanished.empty());
  CHECK(areas_of(result) == std::vector<Rational>{77, 4});
  CHECK(faults_of(drawn(result.coverage)).empty());
}

TEST_CASE("overlaps that stay are in the polygons of both") {
  const SegmentSet input = layer({rectangle(0, 0, 5, 4), rectangle(3, 1, 8, 3)});
  CleanOptions options;
  options.overlaps.width = 1;
  const CleanCoverage result = clean(input, options);
  CHECK(result.changes.empty());
  const Checked again(drawn(result.coverage));
  CHECK(polygon_areas(again.coverage) == std::vector<Rational>{20, 10});
  CHECK(text_of({again.faults.front()}) == "overlap 0 1 area 4\n");
}

TEST_CASE("no polygon gets vertices that are nobody's corner beside it") {
  const SegmentSet input = layer({rectangle(0, 0, 3, 2), rectangle(2, 0, 4, 2)});
  const CleanCoverage result = clean(input);
  CHECK(result.coverage.complex.vertices.size() == 6);
  CHECK(validate(result.coverage.complex).empty());
}

TEST_CASE("a clean coverage has no faults and covers what was covered, exactly") {
  std::mt19937 random(3);
  for (int round = 0; round < 30; ++round) {
    std::vector<Corners> triangles = random_triangles(random, 2 + round / 2);
    const SegmentSet input = layer(triangles);
    const Checked before(input);
    CleanOptions options;
    options.policy = static_cast<CoveragePolicy>(round % 4);
    const CleanCoverage result = cleaned(before.coverage, input, before.faults, options);
    Rational filled = 0;
    for (const Reassigned& change : result.changes) {
      if (change.fault.kind == CoverageFaultKind::Gap) filled += change.fault.area;
      CHECK(std::ranges::count(change.fault.polygons, change.to) == 1);
    }
    const std::vector<Rational> areas = areas_of(result);
    CHECK(sum(areas) == covered(before.coverage) + filled);
    CHECK(validate(result.coverage.complex).empty());
    const SegmentSet again = drawn(result.coverage);
    CHECK(faults_of(again).empty());
    CHECK(ring_problems(again, arrange(again)).empty());

    // In another order of the polygons each has the same area, unless the order decides.
    if (options.policy == CoveragePolicy::First) continue;
    std::vector<std::size_t> order(triangles.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    std::vector<Corners> shuffled;
    for (const std::size_t i : order) shuffled.push_back(triangles[i]);
    const std::vector<Rational> others = areas_of(clean(layer(shuffled), options));
    for (std::size_t i = 0; i < order.size(); ++i) CHECK(others[i] == areas[order[i]]);
  }
}

TEST_CASE("policies are words") {
  CHECK(coverage_policy("longest-border") == CoveragePolicy::LongestBorder);
  CHECK(to_text(coverage_policy("first")) == "first");
  CHECK_THROWS_WITH(coverage_policy("best"), Catch::Contains("longest-border, largest"));
}

// Where the published pipeline would outgrow time or memory, and what the repaired one does there.

#include <catch2/catch.hpp>

#include "plumbline/engines/inters_stages.hpp"
#include "plumbline/engines/lar_stages.hpp"
#include "support/segments.hpp"

using namespace plumbline;
using namespace plumbline::lar;

namespace {

/// n separate triangles in rows of 50.
std::vector<SegmentD> triangles(std::size_t n) {
  std::vector<SegmentD> lines;
  for (std::size_t i = 0; i < n; ++i) {
    const PointD p{static_cast<double>(i % 50), static_cast<double>(i / 50)};
    const PointD q{p.x + 0.5, p.y + 0.125}, r{p.x + 0.25, p.y + 0.5};
    lines.insert(lines.end(), {{p, q}, {q, r}, {r, p}});
  }
  return lines;
}

/// Walls of width x height rooms of side 1/64: long walls would fall apart by their quantised
/// parameters.
std::vector<SegmentD> rooms(int width, int height) {
  constexpr double kSide = 1.0 / 64;
  std::vector<SegmentD> lines;
  for (int x = 0; x <= width; ++x) {
    lines.push_back({{x * kSide, 0}, {x * kSide, height * kSide}});
  }
  for (int y = 0; y <= height; ++y) {
    lines.push_back({{0, y * kSide}, {width * kSide, y * kSide}});
  }
  return lines;
}

std::vector<std::string> limits(const inters::Trace& trace) {
  std::vector<std::string> stages;
  for (const inters::Failure& failure : trace.failures) {
    if (failure.error == "Limit") stages.push_back(failure.stage);
  }
  return stages;
}

FloatComplex repaired(const std::vector<SegmentD>& lines) {
  SegmentSet input;
  input.add_file("lines");
  for (const SegmentD& line : lines) input.add(line.a, line.b, input.add_source({}));
  return lar::arrange(input, {1e-9}).complex;
}

}  // namespace

TEST_CASE("cycles are compared each with each up to 1000 components, beyond that is a failure") {
  const inters::Trace within = inters::run(triangles(1000));
  CHECK(limits(within).empty());
  REQUIRE(within.lattice);
  CHECK(within.lattice->size() == 1000);

  const inters::Trace beyond = inters::run(triangles(1001));
  CHECK(limits(beyond) == std::vector<std::string>{"latticeArray"});
  CHECK(beyond.components.size() == 1001);
  CHECK(beyond.boundary_cycles.size() == 1001);  // the stages before and beside have their outputs
  CHECK_FALSE(beyond.lattice);
  CHECK_FALSE(beyond.cells);
  CHECK_FALSE(beyond.two_complex);
  CHECK(repaired(triangles(1001)).face_count() == 1002);
}

TEST_CASE("faces are compared each with each up to 1000, beyond that is a failure") {
  const inters::Trace within = inters::run(rooms(40, 25));
  CHECK(limits(within).empty());
  REQUIRE(within.faces_lattice);
  CHECK(within.faces_lattice->size() == 1000);

  const inters::Trace beyond = inters::run(rooms(41, 25));
  CHECK(limits(beyond) == std::vector<std::string>{"facesLattice"});
  CHECK_FALSE(beyond.faces_lattice);
  REQUIRE(beyond.lar_from_lines);
  CHECK(beyond.lar_from_lines->faces.size() == 1025);
  CHECK(repaired(rooms(41, 25)).face_count() == 1026);
}

TEST_CASE("published buckets of long walls grow with the product of their numbers, up to a limit") {
  std::vector<Box> boxes;
  for (const SegmentD& wall : rooms(60, 60)) {
    boxes.push_back({wall.a.x, wall.a.y, wall.b.x, wall.b.y});
  }
  // Each wall meets the 61 across it, so it must share a bucket with them.
  const Lists<SegmentId> buckets = inters::box_buckets(boxes);
  const std::size_t partners = buckets.flat().size();
  CHECK(partners >= 2 * 61 * 61);
  CHECK_THROWS_WITH(inters::box_buckets(boxes, partners - 1), Catch::Contains("without bound"));
  CHECK_THROWS_WITH(inters::box_buckets(boxes, 2 * boxes.size()), Catch::Contains("without bound"));
  CHECK(inters::box_buckets(boxes, 20 * partners) == buckets);
}

TEST_CASE("pairs of near vertices are listed up to a limit; the repaired merging lists none") {
  std::vector<PointD> crowd;
  for (int i = 0; i < 100; ++i) crowd.push_back({i * 1e-6, 0});
  CHECK(inters::prune_vertices(crowd, 0.001, 4950).close.size() == 4950);
  CHECK_THROWS_WITH(inters::prune_vertices(crowd, 0.001, 4949),
                    Catch::Contains("within the radius"));
  CHECK(inters::prune_vertices(crowd, 0.001).vertices.size() == 1);
}

TEST_CASE("each two lines of a jittered pencil cut each other, up to a limit") {
  // Tangents of a parabola: the i-th and the j-th meet at x = i + j, no three in one point.
  constexpr std::size_t kLines = 100;
  Graph pencil;
  for (std::size_t i = 0; i < kLines; ++i) {
    const auto slope = static_cast<double>(i);
    pencil.vertices.push_back({-1, slope * (-1 - slope)});
    pencil.vertices.push_back({2 * kLines, slope * (2 * kLines - slope)});
    pencil.edges.push_back({VertexId(2 * i), VertexId(2 * i + 1)});
    pencil.edge_sources.push_back(std::vector<SegmentId>{SegmentId(i)});
  }
  constexpr double kRadius = 1e-6;
  const std::vector<Box> boxes = containment_boxes(pencil, kRadius);
  const Lists<EdgeId> buckets = box_buckets(boxes);
  constexpr std::size_t kCuts = kLines * (kLines - 1);
  CHECK(cut_edges(pencil, boxes, buckets, kRadius, kCuts).flat().size() == kCuts);
  CHECK_THROWS_WITH(cut_edges(pencil, boxes, buckets, kRadius, kCuts - 1),
                    Catch::Contains("too many places"));
}

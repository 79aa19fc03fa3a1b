// The benchmark's inputs have the counts that were published of them.

#include "inputs/workloads.hpp"

#include <catch2/catch.hpp>

#include "inputs/hostile.hpp"
#include "plumbline/arrange.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// "V E F" of the arrangement.
std::string text(std::size_t vertices, std::size_t edges, std::size_t faces) {
  return std::to_string(vertices) + " " + std::to_string(edges) + " " + std::to_string(faces);
}

std::string cells(const SegmentSet& input) {
  const ExactComplex complex = arrange(input);
  return text(complex.vertices.size(), complex.edge_count(), complex.face_count());
}

}  // namespace

TEST_CASE("workloads have the counts of CGAL's arrangement and of the prototype") {
  const char* name =
      GENERATE("R1_1e3", "R1_1e4", "R5_5e3", "G_300", "Gr_300", "D_1e4", "S_1e4", "S1_1e3");
  CAPTURE(name);
  const inputs::Known* known = inputs::known(name);
  REQUIRE(known != nullptr);
  const SegmentSet input = inputs::workload(name);
  CHECK(input.segments.size() == known->segments);
  CHECK(input.rejected.empty());
  CHECK(cells(input) == text(known->vertices, known->edges, known->faces));
}

TEST_CASE("a plan of double walls has the cells that its geometry says") {
  // Four lines' crossings a corner; a room has two jambs between its lines and an open door.
  const std::size_t m = 3, lines = 2 * (m + 1);
  const std::size_t vertices = lines * lines + 5 * m * m;
  const std::size_t edges = 2 * lines * (lines - 1) + 7 * m * m;
  const SegmentSet input = inputs::workload("W_3");
  CHECK(input.segments.size() == 11 * m * m);
  CHECK(cells(input) == text(vertices, edges, 2 + edges - vertices));
}

TEST_CASE("hostile inputs have the cells that their geometry says") {
  int known = 0;
  for (const auto& hostile : inputs::hostile()) {
    const auto expected = hostile.cells(hostile.small_size);
    if (!expected) continue;
    CAPTURE(hostile.name, hostile.small_size);
    CHECK(cells(hostile.make(hostile.small_size)) ==
          text(expected->vertices, expected->edges, expected->faces));
    ++known;
  }
  CHECK(known >= 14);
}

TEST_CASE("tiles of a drawing that do not touch have its counts times their number") {
  const SegmentSet square = segments(rectangle(0, 0, 9, 9));
  CHECK(cells(inputs::tiles(square, 5, 10, 0)) == "20 20 6");
  CHECK(cells(inputs::tiles(square, 5, 9, 9)) == "16 20 6");
}

TEST_CASE("a name that is no workload's, and a missing drawing, are errors") {
  const char* name =
      GENERATE("", "R1", "R1_", "R1_x", "R1_0", "R1_1e9", "R1_1.5", "X_10", "R1_10x");
  CHECK_THROWS_AS(inputs::workload(name), Error);
  CHECK_THROWS_AS(inputs::workload("P_1", "no such directory"), Error);
}

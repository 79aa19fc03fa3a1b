// Boundaries of chains of faces, and the map to the unit square.

#include <catch2/catch.hpp>
#include <set>

#include "plumbline/lar.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

FloatComplex complex_of(const std::string& text) { return lar::arrange(segments(text)).complex; }

}  // namespace

TEST_CASE("the boundary of a chain of faces is its closed walks, faces in common cancel") {
  // Two rooms side by side, one with a hole that is a face.
  const FloatComplex c =
      complex_of(rectangle(0, 0, 4, 4) + rectangle(4, 0, 8, 4) + rectangle(1, 1, 2, 2));
  REQUIRE(c.face_count() == 4);
  const auto face_at = [&](double x, double y) {
    return locate(exact(c), Point{rational_from(x), rational_from(y)});
  };
  const FaceId left = face_at(3, 3), right = face_at(6, 2), hole = face_at(1.5, 1.5);
  const auto cycles = [&](std::vector<FaceId> chain) {
    std::multiset<std::size_t> sizes;
    const Lists<HalfedgeId> found = lar::boundary_cycles(c, chain);
    for (std::size_t i = 0; i < found.size(); ++i) sizes.insert(found[i].size());
    return sizes;
  };
  CHECK(cycles({left}) == std::multiset<std::size_t>{4, 4});
  CHECK(cycles({right}) == std::multiset<std::size_t>{4});
  CHECK(cycles({left, right}) == std::multiset<std::size_t>{4, 6});
  CHECK(cycles({left, right, hole}) == std::multiset<std::size_t>{6});
  CHECK(cycles({}).empty());
  CHECK(lar::boundary_chain(c, std::vector{left, hole}).size() == 4);
  CHECK_THROWS_AS(cycles({FaceId(4)}), Error);
  const auto polylines = lar::boundary_polylines(c, std::vector{hole});
  REQUIRE(polylines.size() == 1);
  CHECK(polylines[0] == std::vector<PointD>{{1, 2}, {1, 1}, {2, 1}, {2, 2}, {1, 2}});
}

TEST_CASE("boundary cycles that touch in a vertex stay apart, antennas bound nothing") {
  const FloatComplex c = complex_of(rectangle(0, 0, 1, 1) + rectangle(1, 1, 2, 2) + "0 0 0.5 0.5");
  REQUIRE(c.face_count() == 3);
  const Lists<HalfedgeId> both = lar::boundary_cycles(c, std::vector{FaceId(1), FaceId(2)});
  REQUIRE(both.size() == 2);
  CHECK(both[0].size() == 4);
  CHECK(both[1].size() == 4);
}

TEST_CASE("the unit square holds every drawing, exactly") {
  const SegmentSet mapped = lar::to_unit_square(segments("1 1 4 1  4 1 4 2  + 2 2"));
  CHECK(to_text(mapped.segments[0]) == "0 1, 1 1");
  CHECK(to_text(mapped.segments[1]) == "1 1, 1 2/3");
  CHECK(to_text(mapped.points[0]) == "1/3 2/3");
  CHECK(to_text(lar::to_unit_square(segments("5 5 5 9")).segments[0]) == "0 1, 0 0");
  CHECK(to_text(lar::to_unit_square(segments("+ 5 5")).points[0]) == "0 1");
  CHECK(lar::to_unit_square(segments("")).segments.empty());
}

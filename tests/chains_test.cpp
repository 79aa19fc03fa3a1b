// Boundaries of chains of faces, bridge edges, and the map to the unit square.

#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "plumbline/arrange.hpp"
#include "plumbline/chains.hpp"
#include "plumbline/engines/inters_stages.hpp"
#include "plumbline/engines/lar.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

FloatComplex complex_of(const std::string& text) { return lar::arrange(segments(text)).complex; }

double area(const std::vector<PointD>& polyline) {
  double doubled = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    doubled += polyline[i - 1].x * polyline[i].y - polyline[i - 1].y * polyline[i].x;
  }
  return doubled / 2;
}

/// Random small squares in a large one, some of them nested, none touching.
std::string scattered_squares(unsigned seed) {
  std::mt19937 random(seed);
  std::string text = rectangle(0, 0, 100, 100);
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 10; ++j) {
      const int x = 10 * i + 1 + static_cast<int>(random() % 3);
      const int y = 10 * j + 1 + static_cast<int>(random() % 3);
      const int side = 2 + static_cast<int>(random() % 4);
      if (random() % 4 == 0) continue;
      text += rectangle(x, y, x + side, y + side);
      if (side > 3) text += rectangle(x + 1, y + 1, x + 2, y + 2);
    }
  }
  return text;
}

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
    const Lists<HalfedgeId> found = boundary_cycles(c, chain);
    for (std::size_t i = 0; i < found.size(); ++i) sizes.insert(found[i].size());
    return sizes;
  };
  CHECK(cycles({left}) == std::multiset<std::size_t>{4, 4});
  CHECK(cycles({right}) == std::multiset<std::size_t>{4});
  CHECK(cycles({left, right}) == std::multiset<std::size_t>{4, 6});
  CHECK(cycles({left, right, hole}) == std::multiset<std::size_t>{6});
  CHECK(cycles({}).empty());
  CHECK(boundary_chain(c, std::vector{left, hole}).size() == 4);
  CHECK_THROWS_AS(cycles({FaceId(4)}), Error);
  const auto polylines = boundary_polylines(c, std::vector{hole});
  REQUIRE(polylines.size() == 1);
  CHECK(polylines[0] == std::vector<PointD>{{1, 2}, {1, 1}, {2, 1}, {2, 2}, {1, 2}});
}

TEST_CASE("boundary cycles that touch in a vertex stay apart, antennas bound nothing") {
  const FloatComplex c = complex_of(rectangle(0, 0, 1, 1) + rectangle(1, 1, 2, 2) + "0 0 0.5 0.5");
  REQUIRE(c.face_count() == 3);
  const Lists<HalfedgeId> both = boundary_cycles(c, std::vector{FaceId(1), FaceId(2)});
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

TEST_CASE(
    "bridges join every hole to its face and cross nothing; the polyline has the face's area") {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const FloatComplex c = complex_of(scattered_squares(seed));
    const std::vector<Rational> areas = face_areas(exact(c));
    SegmentSet with_bridges;
    const SourceId source = with_bridges.add_source({});
    for (const Edge& e : c.edges) with_bridges.add(c.vertices[e.tail], c.vertices[e.head], source);
    std::size_t bridges = 0;
    for (std::size_t f = 1; f < c.face_count(); ++f) {
      const FaceId face(f);
      const auto found = bridge_edges(c, face);
      CHECK(found.size() == c.face_holes[face].size());
      bridges += found.size();
      for (const auto& [v, w] : found) with_bridges.add(c.vertices[v], c.vertices[w], source);
      const std::vector<PointD> polyline = lar::single_polyline(c, face);
      std::size_t edges = c.cycles[c.face_outer[face]].size();
      for (const CycleId hole : c.face_holes[face]) edges += c.cycles[hole].size();
      CHECK(polyline.size() == edges + 2 * found.size() + 1);
      CHECK(polyline.front() == polyline.back());
      CHECK(area(polyline) == nearest_double(areas[face]));
    }
    CHECK(bridges > 50);
    const ExactComplex joined = arrange(with_bridges);
    CHECK(joined.vertices.size() == c.vertices.size());
    CHECK(joined.edge_count() == c.edge_count() + bridges);
    CHECK(joined.component_count() == 1);
  }
}

TEST_CASE("faces with antennas and cut vertices have one polyline too") {
  const FloatComplex c = complex_of(rectangle(0, 0, 9, 9) + "0 0 3 3  " + rectangle(5, 5, 6, 6) +
                                    "6 6 7 7  " + rectangle(7, 7, 8, 8));
  REQUIRE(c.face_count() == 4);
  const std::vector<Rational> areas = face_areas(exact(c));
  for (std::size_t f = 1; f < 4; ++f) {
    CHECK(area(lar::single_polyline(c, FaceId(f))) == nearest_double(areas[f]));
  }
  CHECK_THROWS_AS(bridge_edges(c, kUnbounded), Error);
  CHECK_THROWS_AS(lar::single_polyline(c, FaceId(4)), Error);
}

TEST_CASE("published bridges are the nearest vertices of two cycles, without the last") {
  using namespace inters;
  // Met at x = 1 from the outer cycle, and again on the way back.
  const Trace one = run(lines(segments(rectangle(0, 0, 10, 10) + rectangle(1, 2, 4, 4))));
  REQUIRE(one.bridge_edges);
  REQUIRE(one.bridge_edges->size() == 1);
  REQUIRE(one.bridge_edges->front().size() == 1);
  std::set<std::pair<double, double>> ends;
  for (const VertexId v : one.bridge_edges->front()[0]) {
    ends.insert({one.lar.vertices[v].x, one.lar.vertices[v].y});
  }
  CHECK(ends == std::set<std::pair<double, double>>{{0, 0}, {1, 2}});
}

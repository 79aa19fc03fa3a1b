#include "plumbline/polygons.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "inputs/families.hpp"
#include "plumbline/arrange.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

Rational twice_area(const ExactComplex& complex, std::span<const VertexId> ring) {
  Rational sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point p = complex.vertices[ring[i]], q = complex.vertices[ring[(i + 1) % ring.size()]];
    sum += p.x * q.y - q.x * p.y;
  }
  return sum;
}

Rational twice_area(const ExactComplex& complex, const FacePolygon& polygon) {
  Rational sum = twice_area(complex, polygon.outer);
  for (std::size_t h = 0; h < polygon.holes.size(); ++h) {
    sum += twice_area(complex, polygon.holes[h]);
  }
  return sum;
}

bool is_simple(std::span<const VertexId> ring) {
  return std::set<std::size_t>(ring.begin(), ring.end()).size() == ring.size() && ring.size() > 2;
}

std::size_t common_vertices(std::span<const VertexId> a, std::span<const VertexId> b) {
  const std::set<std::size_t> first(a.begin(), a.end());
  return static_cast<std::size_t>(
      std::count_if(b.begin(), b.end(), [&](VertexId v) { return first.contains(v); }));
}

std::vector<FacePolygon> of(const std::string& drawing) {
  return polygons(arrange(segments(drawing)));
}

}  // namespace

TEST_CASE("a face with a hole is an outer ring and a hole") {
  const auto faces = of(rectangle(0, 0, 9, 9) + rectangle(3, 3, 6, 6));
  REQUIRE(faces.size() == 2);
  CHECK(faces[0].outer.size() == 4);
  CHECK(faces[0].holes.size() == 1);
  CHECK(faces[1].holes.size() == 0);
}

TEST_CASE("antennas are beside the rings") {
  SECTION("a dangling edge") {
    const auto faces = of(rectangle(0, 0, 9, 9) + "0 4 5 4");
    REQUIRE(faces.size() == 1);
    CHECK(faces[0].outer.size() == 5);
    CHECK(faces[0].antennas.size() == 1);
  }
  SECTION("a bridge between boundary and hole") {
    const auto faces = of(rectangle(0, 0, 9, 9) + rectangle(3, 3, 6, 6) + "0 3 3 3");
    REQUIRE(faces.size() == 2);
    CHECK(faces[0].outer.size() == 5);
    REQUIRE(faces[0].holes.size() == 1);
    CHECK(faces[0].holes[0].size() == 4);
    CHECK(faces[0].antennas.size() == 1);
  }
  SECTION("a tree of them is no hole") {
    const auto faces = of(rectangle(0, 0, 9, 9) + "2 2 4 4  4 4 4 6  4 4 6 4");
    REQUIRE(faces.size() == 1);
    CHECK(faces[0].holes.size() == 0);
    CHECK(faces[0].antennas.size() == 3);
  }
}

TEST_CASE("a boundary that touches itself is parted there") {
  SECTION("a triangle that hangs at a corner from inside") {
    const auto faces = of(rectangle(0, 0, 9, 9) + "0 0 3 6  3 6 6 3  6 3 0 0");
    REQUIRE(faces.size() == 2);
    CHECK(faces[0].outer.size() == 4);
    REQUIRE(faces[0].holes.size() == 1);
    CHECK(faces[0].holes[0].size() == 3);
  }
  SECTION("two holes that touch") {
    const auto faces = of(rectangle(0, 0, 9, 9) + rectangle(1, 1, 3, 3) + rectangle(3, 3, 6, 6));
    REQUIRE(faces.size() == 3);
    CHECK(faces[0].holes.size() == 2);
  }
}

TEST_CASE("rings are simple, touch in one point at most and have the area of the face") {
  std::size_t holes = 0, antennas = 0;
  for (const std::string& family : inputs::families()) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
      INFO(family << ' ' << seed);
      const ExactComplex complex = arrange(inputs::of_family(family, seed));
      const std::vector<Rational> areas = face_areas(complex);
      const auto faces = polygons(complex);
      REQUIRE(faces.size() + 1 == complex.face_count());
      std::size_t edges = 0;
      for (const FacePolygon& face : faces) {
        CHECK(twice_area(complex, face) == 2 * areas[face.face]);
        std::vector<std::span<const VertexId>> rings{face.outer};
        for (std::size_t h = 0; h < face.holes.size(); ++h) rings.push_back(face.holes[h]);
        for (std::size_t i = 0; i < rings.size(); ++i) {
          CHECK(is_simple(rings[i]));
          CHECK((twice_area(complex, rings[i]) > 0) == (i == 0));
          for (std::size_t j = i + 1; j < rings.size(); ++j) {
            CHECK(common_vertices(rings[i], rings[j]) <= 1);
          }
          edges += rings[i].size();
        }
        holes += face.holes.size();
        antennas += face.antennas.size();
        edges += 2 * face.antennas.size();
      }
      std::size_t expected = 0;
      for (std::size_t f = 1; f < complex.face_count(); ++f) {
        expected += static_cast<std::size_t>(
            std::count(complex.halfedge_face.begin(), complex.halfedge_face.end(), FaceId(f)));
      }
      CHECK(edges == expected);
    }
  }
  CHECK(holes > 10);
  CHECK(antennas > 100);
}

TEST_CASE("neighbours share edges, and lengths of walls add up to the perimeter") {
  const ExactComplex complex = arrange(segments(rectangle(0, 0, 8, 4) + "4 0 4 4  6 4 6 2"));
  const auto next = neighbours(complex);
  REQUIRE(next.size() == 3);
  CHECK(next[1] == std::vector<Neighbour>{{kUnbounded, 12}, {FaceId(2), 4}});
  CHECK(next[0] == std::vector<Neighbour>{{FaceId(1), 12}, {FaceId(2), 12}});
  CHECK(perimeters(complex) == std::vector<double>{24, 16, 16});
  const auto sources = face_sources(complex);
  CHECK(sources[1].size() == 4);
  CHECK(sources[2].size() == 5);
}

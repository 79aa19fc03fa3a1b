#include "plumbline/chains/triangulate.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

Rational area(const ExactComplex& c, const std::vector<Triangle>& triangles) {
  Rational doubled = 0;
  for (const Triangle& t : triangles) {
    const Point &p = c.vertices[t[0]], &q = c.vertices[t[1]], &r = c.vertices[t[2]];
    const Rational turn = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    CHECK(turn > 0);
    doubled += turn;
  }
  return doubled / 2;
}

/// Euler: a polygon of n vertices (with repetition) and h holes has n + 2 h - 2 triangles.
std::size_t expected_triangles(const ExactComplex& c, FaceId face) {
  std::size_t corners = c.cycles[c.face_outer[face]].size();
  for (const CycleId hole : c.face_holes[face]) corners += c.cycles[hole].size();
  return corners + 2 * c.face_holes[face].size() - 2;
}

}  // namespace

TEST_CASE("the triangles of every face have its area, and as many as Euler says") {
  for (const std::string& text :
       {rectangle(0, 0, 1, 1),
        rectangle(0, 0, 9, 9) + rectangle(1, 1, 3, 3) + rectangle(5, 5, 8, 8),
        rectangle(0, 0, 9, 9) + rectangle(1, 1, 8, 8) + rectangle(2, 2, 7, 7),
        std::string("0 0 7 1/3  7 1/3 5 5  5 5 3 1  3 1 1/7 6  1/7 6 0 0"),
        rectangle(0, 0, 4, 4) + "2 0 3 1  3 1 1 1  1 1 2 0  0 2 4 4"}) {
    const ExactComplex c = arrange(segments(text));
    const std::vector<Rational> areas = face_areas(c);
    for (std::size_t f = 1; f < c.face_count(); ++f) {
      const std::vector<Triangle> triangles = triangulate(c, FaceId(f));
      CHECK(area(c, triangles) == areas[f]);
      CHECK(triangles.size() == expected_triangles(c, FaceId(f)));
      CHECK(std::is_sorted(triangles.begin(), triangles.end()));
    }
  }
}

TEST_CASE("antennas and isolated vertices take no part") {
  const ExactComplex c = arrange(segments(rectangle(0, 0, 4, 4) + "0 0 1 1  2 2 3 3  + 1 3"));
  REQUIRE(c.face_count() == 2);
  CHECK(triangulate(c, FaceId(1)).size() == 2);
  CHECK(area(c, triangulate(c, FaceId(1))) == 16);
}

TEST_CASE("coordinates of any size are exact") {
  const ExactComplex c = arrange(segments("0 0 1e90 1e-90  1e90 1e-90 0 1e90  0 1e90 0 0"));
  REQUIRE(c.face_count() == 2);
  CHECK(area(c, triangulate(c, FaceId(1))) == face_areas(c)[1]);
}

TEST_CASE("other faces and crossing edges are refused") {
  const ExactComplex c = arrange(segments(rectangle(0, 0, 1, 1)));
  CHECK_THROWS_AS(triangulate(c, kUnbounded), Error);
  CHECK_THROWS_AS(triangulate(c, FaceId(2)), Error);
  ExactComplex bow = c;
  bow.vertices.replace(2, c.vertices[3]);
  bow.vertices.replace(3, c.vertices[2]);
  CHECK_THROWS_AS(triangulate(bow, FaceId(1)), Error);
}

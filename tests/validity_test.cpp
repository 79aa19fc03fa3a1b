// Whether polygons are valid, and valid ones in their place.

#include "plumbline/validity.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <string>

#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "plumbline/read.hpp"

using namespace plumbline;

namespace {

SegmentSet wkt(const std::string& text) { return evaluate(read_wkt(text, "a.wkt")); }

std::vector<PolygonValidity> validity_of(const SegmentSet& input) {
  return validity(input, arrange(input));
}

/// "linework: 1 + 1 structure: 2 nonzero: ", the areas of the polygons that are made of the first.
std::string made(const std::string& text) {
  const SegmentSet input = wkt(text);
  const PolygonValidity polygon = validity_of(input).at(0);
  std::string result;
  for (const std::string_view word : kValidMeanings) {
    result += (result.empty() ? "" : ", ") + std::string(word);
    for (const Rational& area : made_valid(input, polygon, valid_meaning(word)).areas) {
      result += ' ' + exact_text(area);
    }
  }
  return result;
}

/// The polygons as a drawing of one multipolygon.
SegmentSet drawn(const RegionPolygons& made) {
  SegmentSet result;
  const SourceId source = result.add_source({});
  const auto add = [&](std::span<const VertexId> ring, RingRole role) {
    result.rings.push_back({static_cast<std::uint32_t>(result.segments.size()),
                            static_cast<std::uint32_t>(ring.size()), role});
    for (std::size_t i = 0; i < ring.size(); ++i) {
      result.add(Segment{made.complex.vertices[ring[i]],
                         made.complex.vertices[ring[(i + 1) % ring.size()]]},
                 source);
    }
  };
  for (const FacePolygon& polygon : made.polygons) {
    add(polygon.outer, result.rings.empty() ? RingRole::Polygon : RingRole::Part);
    for (std::size_t h = 0; h < polygon.holes.size(); ++h) add(polygon.holes[h], RingRole::Hole);
  }
  return result;
}

Rational sum(const std::vector<Rational>& areas) {
  Rational result = 0;
  for (const Rational& area : areas) result += area;
  return result;
}

}  // namespace

TEST_CASE("each polygon has its own problems") {
  const SegmentSet input =
      wkt("POLYGON ((0 0, 4 0, 4 4, 0 0)); POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0));"
          "POLYGON EMPTY; MULTIPOLYGON (((9 9, 8 9, 8 8, 9 9)), ((9 9, 8 9, 8 8, 9 9)))");
  const auto found = validity_of(input);
  REQUIRE(found.size() == 3);
  CHECK(found[0].is_valid());
  REQUIRE(found[1].problems.size() == 1);
  CHECK(found[1].problems[0].where == Point{1, 1});
  CHECK_FALSE(found[2].is_valid());
  CHECK(found[2].last_ring == found[2].first_ring + 1);
  CHECK(first_segment(input, found[1]) == 3);
  CHECK(validity_of(wkt("POLYGON EMPTY")).empty());
}

TEST_CASE("a valid polygon is itself by every meaning") {
  CHECK(made("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))") ==
        "linework 12, structure 12, nonzero 12");
}

TEST_CASE("a bow tie is two triangles") {
  CHECK(made("POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))") == "linework 1 1, structure 1 1, nonzero 1 1");
}

TEST_CASE("a part of a ring that goes around twice is in or out") {
  // The square [1, 2]^2 lies in both loops.
  CHECK(made("POLYGON ((0 0, 2 0, 2 2, 1 2, 1 1, 3 1, 3 3, 0 3, 0 0))") ==
        "linework 7, structure 8, nonzero 8");
}

TEST_CASE("a hole that sticks out adds by linework and by its direction") {
  CHECK(made("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (3 1, 3 2, 6 2, 6 1, 3 1))") ==
        "linework 15 2, structure 15, nonzero 15 2");
  CHECK(made("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (3 1, 6 1, 6 2, 3 2, 3 1))") ==
        "linework 15 2, structure 15, nonzero 18");
}

TEST_CASE("a hole takes from its own part only") {
  CHECK(made("MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1)), "
             "((2 0, 6 0, 6 4, 2 4, 2 0)))") == "linework 6 2 8, structure 22, nonzero 22");
}

TEST_CASE("an open ring is closed by a straight line, and of a line nothing is left") {
  CHECK(made("POLYGON ((0 0, 4 0, 4 4))") == "linework 8, structure 8, nonzero 8");
  CHECK(made("POLYGON ((0 0, 4 0, 0 0))") == "linework, structure, nonzero");
}

TEST_CASE("what is made valid is valid, and what nonzero covers is at least what evenodd does") {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> place(0, 12), count(4, 9);
  for (int round = 0; round < 150; ++round) {
    std::string text = "POLYGON (";
    for (int ring = 0; ring < 1 + round % 3; ++ring) {
      std::string first, points;
      for (int i = count(random); i > 0; --i) {
        const std::string point =
            std::to_string(place(random)) + ' ' + std::to_string(place(random));
        if (first.empty()) first = point;
        points += point + ", ";
      }
      text += (ring > 0 ? ", (" : "(") + points + first + ")";
    }
    const SegmentSet input = wkt(text + ")");
    const PolygonValidity polygon = validity_of(input).at(0);
    std::vector<Rational> areas;
    for (const auto meaning :
         {ValidMeaning::Linework, ValidMeaning::Structure, ValidMeaning::NonZero}) {
      const RegionPolygons result = made_valid(input, polygon, meaning);
      const SegmentSet again = drawn(result);
      CHECK(ring_problems(again, arrange(again)).empty());
      areas.push_back(sum(result.areas));
      if (polygon.is_valid() && meaning != ValidMeaning::NonZero) CHECK(areas.back() == areas[0]);
    }
    CHECK(areas[2] >= areas[0]);
  }
}

TEST_CASE("meanings are words") { CHECK_THROWS_AS(valid_meaning("buffer"), Error); }

// Two layers of polygons over each other.

#include "plumbline/overlay.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <random>

#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "plumbline/features.hpp"

using namespace plumbline;

namespace {

using Corners = std::vector<std::array<int, 2>>;

/// Polygons, each of one ring, as readers make them.
SegmentSet layer(const std::string& file, const std::vector<Corners>& polygons) {
  SegmentSet result;
  result.add_file(file);
  for (const Corners& corners : polygons) {
    Source source;
    source.element = "Polygon";
    source.id = std::to_string(result.rings.size() + 1);
    const SourceId id = result.add_source(source);
    result.rings.push_back({static_cast<std::uint32_t>(result.segments.size()),
                            static_cast<std::uint32_t>(corners.size()), RingRole::Polygon});
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto& [ax, ay] = corners[i];
      const auto& [bx, by] = corners[(i + 1) % corners.size()];
      result.add(Segment{{ax, ay}, {bx, by}}, id);
    }
  }
  return result;
}

Corners square(int x, int y, int side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

Rational area(const SegmentSet& a, const SegmentSet& b, OverlayHow how) {
  return overlay(a, b, how).area();
}

/// A triangle with corners on a small grid, none of area 0.
Corners random_triangle(std::mt19937& random) {
  std::uniform_int_distribution<int> place(-20, 20);
  while (true) {
    Corners c;
    for (int i = 0; i < 3; ++i) c.push_back({place(random), place(random)});
    const int twice =
        (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0]);
    if (twice != 0) return c;
  }
}

}  // namespace

TEST_CASE("parcels and zones are parted as a table of GeoPandas parts them") {
  // The example of its manual, "Set operations with overlay": two layers of two squares each.
  const SegmentSet first = layer("a", {square(0, 0, 2), square(2, 2, 2)});
  const SegmentSet second = layer("b", {square(1, 1, 2), square(3, 3, 2)});
  const auto parts = [&](OverlayHow how) { return overlay(first, second, how).pieces.size(); };
  CHECK(parts(OverlayHow::Intersection) == 3);
  CHECK(parts(OverlayHow::Union) == 7);
  CHECK(parts(OverlayHow::SymmetricDifference) == 4);
  CHECK(parts(OverlayHow::Difference) == 2);
  CHECK(parts(OverlayHow::Identity) == 5);
  CHECK(area(first, second, OverlayHow::Intersection) == 3);
  CHECK(area(first, second, OverlayHow::Union) == 13);
}

TEST_CASE("areas of overlays add up to the last digit") {
  std::mt19937 random(17);
  for (int round = 0; round < 40; ++round) {
    std::vector<Corners> a, b;
    for (int i = 0; i <= round % 5; ++i) {
      a.push_back(random_triangle(random));
      b.push_back(random_triangle(random));
    }
    const SegmentSet first = layer("a", a), second = layer("b", b), none = layer("none", {});
    const Rational of_first = area(first, none, OverlayHow::Union);
    const Rational of_second = area(none, second, OverlayHow::Union);
    const Rational both = area(first, second, OverlayHow::Intersection);
    CHECK(area(first, second, OverlayHow::Union) == of_first + of_second - both);
    CHECK(area(first, second, OverlayHow::Difference) == of_first - both);
    CHECK(area(first, second, OverlayHow::SymmetricDifference) == of_first + of_second - 2 * both);
    CHECK(area(first, second, OverlayHow::Identity) == of_first);
    CHECK(area(second, first, OverlayHow::Intersection) == both);
    CHECK(area(first, first, OverlayHow::SymmetricDifference) == 0);
    CHECK(area(first, first, OverlayHow::Intersection) == of_first);
  }
}

TEST_CASE("a piece lies in all polygons that overlap there, and edges know their lines") {
  const SegmentSet first = layer("a", {square(0, 0, 4), square(2, 0, 4)});
  const SegmentSet second = layer("b", {square(3, 1, 1)});
  const Overlay made = overlay(first, second, OverlayHow::Intersection);
  REQUIRE(made.pieces.size() == 1);
  CHECK(made.pieces[0].first == std::vector<RegionId>{RegionId(0), RegionId(1)});
  CHECK(made.pieces[0].second == std::vector<RegionId>{RegionId(2)});
  CHECK(made.pieces[0].area == 1);
  // The right side lies on that of the first square, too.
  std::size_t of_two = 0;
  for (std::size_t e = 0; e < made.complex.edge_count(); ++e) {
    of_two += made.complex.edge_sources[e].size() == 2;
  }
  CHECK(of_two == 1);
}

TEST_CASE("polygons with a side in common have no intersection, GEOS #1525") {
  const SegmentSet first = layer("a", {{{1, 0}, {1, 1}, {1, 3}, {4, 0}}});
  const SegmentSet second = layer("b", {{{0, 4}, {1, 3}, {1, 0}}});
  CHECK(overlay(first, second, OverlayHow::Intersection).pieces.empty());
  CHECK(area(first, second, OverlayHow::Union) == 6);
  CHECK(area(first, second, OverlayHow::Difference) == Rational(9, 2));
}

TEST_CASE("parts of pieces are features with the elements that they lie in") {
  const SegmentSet first = layer("a", {square(0, 0, 3)});
  const SegmentSet second = layer("b", {{{1, -1}, {2, -1}, {2, 4}, {1, 4}}});
  const Overlay made = overlay(first, second, OverlayHow::Difference);
  REQUIRE(made.pieces.size() == 1);
  const FeatureLayer features = piece_layer(made, safely_rounded(made.complex, {}));
  REQUIRE(features.features.size() == 2);
  for (const Feature& feature : features.features) {
    CHECK(std::get<std::int64_t>(feature.values[0]) == 1);
    CHECK(std::get<std::string>(feature.values[1]) == "a Polygon #1");
    CHECK(std::get<std::string>(feature.values[2]).empty());
    CHECK(std::get<std::string>(feature.values[4]) == "3");
  }
}

TEST_CASE("drawings of two systems of coordinates are refused") {
  SegmentSet first = layer("a", {square(0, 0, 2)}), second = layer("b", {square(1, 1, 2)});
  first.crs = "EPSG:25832";
  CHECK_NOTHROW(together(first, second));
  second.crs = "EPSG:4326";
  CHECK_THROWS_WITH(together(first, second), Catch::Contains("EPSG:25832 and EPSG:4326"));
  CHECK_THROWS_AS(overlay_how("clip"), Error);
  CHECK(to_text(overlay_how("symmetric_difference")) == "symmetric_difference");
}

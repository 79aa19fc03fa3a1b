// Laws of sets that regions keep to the last digit, on the families of the campaign.

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <random>
#include <tuple>

#include "inputs/families.hpp"
#include "plumbline/dissolve.hpp"
#include "plumbline/overlay.hpp"

using namespace plumbline;

namespace {

using Corners = std::vector<Point>;
constexpr unsigned kSeeds = 2;

/// One polygon of a ring, which may cross and run along itself.
SegmentSet polygon(const Corners& corners) {
  SegmentSet result;
  result.add_file("ring");
  const SourceId id = result.add_source({});
  for (std::size_t i = 0; i < corners.size(); ++i) {
    result.add(Segment{corners[i], corners[i + 1 == corners.size() ? 0 : i + 1]}, id);
  }
  result.rings.push_back(
      {0, static_cast<std::uint32_t>(result.segments.size()), RingRole::Polygon});
  return result;
}

/// The ends of the segments of an input, one after the other, as corners of three rings.
std::vector<Corners> rings_of(const std::string& family, unsigned seed) {
  const SegmentSet input = inputs::of_family(family, seed);
  std::vector<Corners> result(3);
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const Segment segment = input.segments[s];
    Corners& corners = result[3 * s / input.segments.size()];
    corners.insert(corners.end(), {segment.a, segment.b});
  }
  return result;
}

SegmentSet whole(const Overlay& made) {
  FaceSet faces(made.complex.face_count());
  for (const Piece& piece : made.pieces) {
    for (const FaceId f : piece.faces) faces[f] = true;
  }
  return drawing_of(region_polygons(made.complex, faces));
}
SegmentSet combined(const SegmentSet& a, const SegmentSet& b, OverlayHow how) {
  return whole(overlay(a, b, how, FillRule::NonZero, 1));
}
Rational area_of(const SegmentSet& a, const SegmentSet& b, OverlayHow how) {
  return overlay(a, b, how, FillRule::NonZero, 1).area();
}
Rational area_of(const SegmentSet& a) { return area_of(a, {}, OverlayHow::Union); }
bool are_same(const SegmentSet& a, const SegmentSet& b) {
  return overlay(a, b, OverlayHow::SymmetricDifference, FillRule::NonZero, 1).pieces.empty();
}

/// All polygons of several drawings, joined at once.
SegmentSet joined_at_once(const std::vector<SegmentSet>& drawings) {
  SegmentSet all;
  for (const SegmentSet& drawing : drawings) all = together(std::move(all), drawing);
  const std::vector<Region> of = regions(all, RegionKind::Polygon, FillRule::NonZero);
  if (of.empty()) return {};
  const std::vector<std::uint32_t> groups(of.size());
  return drawing_of(dissolve(all, of, groups, 1).front());
}

void for_each_input(const std::function<void(const std::vector<SegmentSet>&)>& check) {
  for (const std::string& family : inputs::families()) {
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
      INFO(family << " " << seed);
      std::vector<SegmentSet> polygons;
      for (const Corners& corners : rings_of(family, seed)) {
        SegmentSet made = polygon(corners);
        if (!made.segments.empty()) polygons.push_back(std::move(made));
      }
      if (polygons.size() == 3) check(polygons);
    }
  }
}

}  // namespace

TEST_CASE("areas of unions and intersections add up on all families") {
  for_each_input([](const auto& p) {
    const auto& [a, b] = std::tie(p[0], p[1]);
    const Rational both = area_of(a, b, OverlayHow::Intersection);
    const Rational of_a = area_of(a), of_b = area_of(b);
    CHECK(area_of(a, b, OverlayHow::Union) + both == of_a + of_b);
    CHECK(area_of(a, b, OverlayHow::Difference) + both == of_a);
    CHECK(area_of(a, b, OverlayHow::SymmetricDifference) + 2 * both == of_a + of_b);
    CHECK(area_of(a, a, OverlayHow::SymmetricDifference) == 0);
    CHECK(are_same(a, a));
  });
}

TEST_CASE("what is in neither is what is in none: De Morgan, with results as inputs") {
  for_each_input([](const auto& p) {
    const auto& [a, b, c] = std::tie(p[0], p[1], p[2]);
    using enum OverlayHow;
    CHECK(are_same(combined(c, combined(a, b, Union), Difference),
                   combined(combined(c, a, Difference), combined(c, b, Difference), Intersection)));
    CHECK(are_same(combined(c, combined(a, b, Intersection), Difference),
                   combined(combined(c, a, Difference), combined(c, b, Difference), Union)));
  });
}

TEST_CASE("many at once are two at a time, in any order") {
  for_each_input([](const auto& p) {
    using enum OverlayHow;
    const SegmentSet at_once = joined_at_once(p);
    CHECK(are_same(at_once, combined(combined(p[0], p[1], Union), p[2], Union)));
    CHECK(are_same(at_once, joined_at_once({p[2], p[0], p[1]})));
    CHECK(area_of(at_once) == area_of(joined_at_once({at_once})));
    CHECK(are_same(combined(combined(p[0], p[1], SymmetricDifference), p[2], SymmetricDifference),
                   combined(p[0], combined(p[2], p[1], SymmetricDifference), SymmetricDifference)));
  });
}

TEST_CASE("maps scale areas, and corners in the middle of sides change nothing") {
  const Rational k(7, 3);
  const auto mapped = [&](const Point& q) {
    return Point{Rational(k * q.x + 2 * q.y + 5), Rational(q.y / 3 - q.x)};
  };
  const Rational determinant = k / 3 + 2;
  std::mt19937 random(7);
  for (const std::string& family : inputs::families()) {
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
      INFO(family << " " << seed);
      std::vector<SegmentSet> plain, image, split;
      for (const Corners& corners : rings_of(family, seed)) {
        Corners of_image, of_split;
        for (std::size_t i = 0; i < corners.size(); ++i) {
          const Point& a = corners[i];
          const Point& b = corners[i + 1 == corners.size() ? 0 : i + 1];
          const Rational t(static_cast<long>(1 + random() % 6), 7);
          of_image.push_back(mapped(a));
          of_split.push_back(a);
          of_split.push_back({Rational(a.x + t * (b.x - a.x)), Rational(a.y + t * (b.y - a.y))});
        }
        plain.push_back(polygon(corners));
        image.push_back(polygon(of_image));
        split.push_back(polygon(of_split));
      }
      for (const OverlayHow how : {OverlayHow::Union, OverlayHow::Intersection}) {
        CHECK(area_of(image[0], image[1], how) == determinant * area_of(plain[0], plain[1], how));
        CHECK(area_of(split[0], split[1], how) == area_of(plain[0], plain[1], how));
      }
      CHECK(are_same(plain[2], split[2]));
    }
  }
}

TEST_CASE("dissolved polygons know their segments, and groups overlap") {
  const auto square = [](int x, int y) {
    return polygon({{x, y}, {x + 2, y}, {x + 2, y + 2}, {x, y + 2}});
  };
  const SegmentSet all = together(together(square(0, 0), square(2, 0)), square(1, 1));
  const std::vector<Region> of = regions(all, RegionKind::Polygon, FillRule::EvenOdd);
  const std::vector<std::uint32_t> groups{0, 0, 2};
  const std::vector<RegionPolygons> made = dissolve(all, of, groups);
  REQUIRE(made.size() == 3);
  CHECK(made[0].areas == std::vector<Rational>{8});
  CHECK(made[1].polygons.empty());
  CHECK(made[2].areas == std::vector<Rational>{4});
  for (std::size_t e = 0; e < made[2].complex.edge_count(); ++e) {
    CHECK(made[2].complex.edge_sources[e].front() >= SegmentId(8));
  }
  CHECK(area_of(drawing_of(made[0])) == 8);
}

// The extent of a drawing, and what is stray.

#include "plumbline/geometry/extent.hpp"

#include <catch2/catch.hpp>
#include <utility>

using namespace plumbline;

namespace {

using Segments = std::vector<SegmentD>;

/// The sides of a square of side 1.
Segments square(double x, double y) {
  return {{{x, y}, {x + 1, y}},
          {{x + 1, y}, {x + 1, y + 1}},
          {{x + 1, y + 1}, {x, y + 1}},
          {{x, y + 1}, {x, y}}};
}

Segments together(Segments a, const Segments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

SegmentD mirrored(const SegmentD& s) { return {{s.a.y, -s.a.x}, {s.b.y, -s.b.x}}; }

}  // namespace

TEST_CASE("a segment far away is stray, wherever it is in the list and in the plane") {
  Segments all = together({{{4000, 0}, {4001, 0}}}, square(0, 0));
  for (int turn = 0; turn < 4; ++turn) {
    const Extent found = extent(all);
    CHECK(found.stray == std::vector<std::size_t>{0});
    CHECK(found.longer_side() == 1);
    CHECK(found.sizes_away == Approx(4000).epsilon(0.01));
    for (SegmentD& s : all) s = mirrored(s);
  }
  std::swap(all.front(), all.back());
  CHECK(extent(all).stray == std::vector<std::size_t>{4});
  CHECK(extent(all).low == PointD{0, 0});
  CHECK(extent(all).high == PointD{1, 1});
}

TEST_CASE("stray segments in different directions do not hide one another") {
  Segments all;
  for (int i = 0; i < 3; ++i) all = together(std::move(all), square(2 * i, 0));
  all = together(std::move(all),
                 {{{1e6, 0}, {1e6, 1}}, {{0, -1e6}, {1, -1e6}}, {{1e9, 1e9}, {1.5e9, 1e9}}});
  CHECK(extent(all).stray == std::vector<std::size_t>{12, 13, 14});
  CHECK(extent(all).longer_side() == 5);
}

TEST_CASE("what lies apart is stray only beyond twenty sizes") {
  CHECK(extent(together(square(0, 0), {{{20, 0}, {20, 1}}})).stray.empty());
  CHECK(extent(together(square(0, 0), {{{22, 0}, {22, 1}}})).stray.size() == 1);
}

TEST_CASE("parts of one weight, in one place or in many, are a drawing") {
  Segments cities;
  for (int i = 0; i < 10; ++i)
    cities = together(std::move(cities), square(1000 * i, 777 * (i % 3)));
  CHECK(extent(cities).stray.empty());
  CHECK(extent(cities).longer_side() == 9001);
  CHECK(extent(together(square(0, 0), square(1e6, 0))).stray.empty());
}

TEST_CASE("a frame around what is finely drawn is no stray element") {
  Segments all;
  for (int i = 0; i < 10; ++i) all = together(std::move(all), square(0, 0));
  const Segments frame{{{-50, -50}, {50, -50}}, {{50, 50}, {-50, 50}}};
  CHECK(extent(together(all, frame)).stray.empty());
  CHECK(extent(together(frame, all)).longer_side() == 100);
}

TEST_CASE("a long line through a drawing is no stray one") {
  const Extent found = extent(together(square(0, 0), {{{0.5, 0.5}, {5000, 0.5}}}));
  CHECK(found.stray.empty());
  CHECK(found.longer_side() == 5000);
}

TEST_CASE("the extent of little is its box") {
  CHECK(extent(Segments{}).longer_side() == 0);
  CHECK(extent(Segments{{{1, 2}, {4, 2}}}).longer_side() == 3);
  SegmentSet set;
  set.add(PointD{1, 2}, PointD{4, 7}, set.add_source({}));
  CHECK(extent(set).low == PointD{1, 2});
  CHECK(extent(set).high == PointD{4, 7});
}

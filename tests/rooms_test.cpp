#include "plumbline/rooms.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "plumbline/geometry/layers.hpp"
#include "rooms/inscribed_circle.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// A drawing of lines with texts, in metres or parts of them.
struct Plan {
  explicit Plan(const std::string& lines, int per_metre = 1) : input(segments(lines)) {
    input.unit = LengthUnit{"", Rational(1, per_metre)};
    input.y_up = true;
  }
  Plan& text(const std::string& words, const Rational& x, const Rational& y) {
    input.labels.push_back({SourceId(0), words, Point{x, y}});
    return *this;
  }
  Rooms rooms(const RoomOptions& options = {}) const {
    return plumbline::rooms(input, arrange(input), options);
  }

  SegmentSet input;
};

std::vector<SegmentD> polygon(const std::vector<PointD>& points) {
  std::vector<SegmentD> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.push_back({points[i], points[(i + 1) % points.size()]});
  }
  return result;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("rooms with walls of no width are neighbours by the length of the wall") {
  const Rooms found = Plan(rectangle(0, 0, 4, 3) + rectangle(4, 0, 9, 5))
                          .text("Bath", 1, 1)
                          .text("7", 6, 1)
                          .text("Kitchen", 6, 2)
                          .rooms();
  REQUIRE(found.rooms.size() == 2);
  CHECK(found.rooms[0].names == Names{"Bath"});
  CHECK(found.rooms[1].names == Names{"Kitchen", "7"});  // from the top, y upwards
  CHECK(found.rooms[0].area == 12);
  CHECK(found.rooms[1].area == 25);
  CHECK(found.rooms[1].perimeter == 20);
  CHECK(found.rooms[0].neighbours == std::vector<RoomNeighbour>{{1, 3, 0, false}});
  CHECK(found.outside.empty());
  CHECK(room_colours(found) == std::vector<std::size_t>{0, 1});
}

TEST_CASE("a room may end in one corner on the right") {
  const Rooms found = Plan("0 0 0 4\n0 4 6 2\n6 2 0 0\n").rooms();
  REQUIRE(found.rooms.size() == 1);
  CHECK(found.rooms[0].area == 12);
  CHECK(found.rooms[0].width == Approx(48 / (4 + 2 * std::sqrt(40))).epsilon(0.02));
}

TEST_CASE("walls are no rooms, rooms on both sides of one face each other") {
  // Outer walls of 0.3 m, a wall of 0.2 m between two rooms of 4 x 3 and 5 x 3 m; in decimetres.
  const std::string walls =
      rectangle(0, 0, 98, 36) + rectangle(3, 3, 43, 33) + rectangle(45, 3, 95, 33);
  const Rooms found = Plan(walls, 10).rooms();
  REQUIRE(found.rooms.size() == 2);
  CHECK(found.narrow == 1);
  CHECK(found.rooms[0].area == 1200);
  CHECK(found.rooms[1].area == 1500);
  REQUIRE(found.rooms[0].neighbours.size() == 1);
  CHECK(found.rooms[0].neighbours[0].shared == 0);
  CHECK(found.rooms[0].neighbours[0].across == Approx(30));
  CHECK(room_colours(found) == std::vector<std::size_t>{0, 1});

  SECTION("all bounded faces on request") {
    RoomOptions all;
    all.min_area = 0;
    all.min_width = 0;
    CHECK(Plan(walls, 10).rooms(all).rooms.size() == 3);
  }
  SECTION("without a unit, too: widths of faces have a gap there") {
    Plan plan(walls);
    plan.input.unit.reset();
    const Rooms without = plan.rooms();
    CHECK(without.rooms.size() == 2);
    CHECK(nearest_double(without.min_width) > 3.5);
    CHECK(nearest_double(without.min_width) < 30);
  }
  SECTION("in other units") {
    RoomOptions options;
    options.unit = LengthUnit{"mm", Rational(1, 1000)};
    CHECK(Plan(walls).rooms(options).rooms.empty());  // all of it is 10 mm large
  }
}

TEST_CASE("a text in a box is the name of the room around it") {
  const Rooms found =
      Plan(rectangle(0, 0, 50, 40) + rectangle(20, 20, 24, 22), 10).text("0.07", 21, 21).rooms();
  REQUIRE(found.rooms.size() == 1);
  CHECK(found.rooms[0].names == Names{"0.07"});
  CHECK(found.rooms[0].gross_area == 2000);
  CHECK(found.rooms[0].area == 1992);
  CHECK(found.narrow == 1);
}

TEST_CASE("a box that hangs on the walls of a room lies in it all the same") {
  const std::string room = rectangle(0, 0, 50, 40), box = rectangle(20, 20, 24, 22);
  const auto hanging = [&](const std::string& lines) {
    return Plan(room + lines, 10).text("7", 21, 21).rooms();
  };
  CHECK(hanging(box + "24 21 50 21\n").rooms.at(0).names == Names{"7"});
  const std::string touching = "20 20 50 20\n50 20 20 22\n20 22 20 20\n";
  CHECK(hanging(touching).rooms.at(0).names == Names{"7"});
  // Between two rooms it lies in neither.
  CHECK(hanging(box + "24 21 50 21\n0 21 20 21\n").outside == std::vector<std::size_t>{0});

  // A light well in the room, as a room of its own, with a line to the wall.
  const Rooms found = Plan(room + rectangle(10, 10, 20, 30) + "20 20 50 20\n", 10).rooms();
  REQUIRE(found.rooms.size() == 2);
  CHECK(found.rooms[0].parent == std::nullopt);
  CHECK(found.rooms[1].parent == 0U);
  CHECK(found.rooms[0].gross_area == 2000);
  CHECK(found.rooms[0].area == 1800);
}

TEST_CASE("a text on a line and one outside belong to no room") {
  const Rooms found = Plan(rectangle(0, 0, 4, 4) + "2 0 2 4\n1 1 1 2\n")
                          .text("on the wall", 2, 1)
                          .text("outside", 9, 9)
                          .text("on a loose line", 1, Rational(3, 2))
                          .text("in", 3, 3)
                          .rooms();
  REQUIRE(found.rooms.size() == 2);
  CHECK(found.rooms[0].names.empty());
  CHECK(found.rooms[1].names == Names{"in"});
  CHECK(found.outside == std::vector<std::size_t>{0, 1, 2});
}

TEST_CASE("the name of a closed element is that of what it encloses, the smallest one first") {
  SegmentSet input;
  const auto add = [&](const std::string& name, const std::string& lines) {
    Source source;
    source.id = name;
    const SourceId id = input.add_source(source);
    for (const Segment& s : segments(lines).segments) input.add(s, id);
    input.labels.push_back({id, name, {}});
  };
  add("flat", rectangle(0, 0, 10, 10));
  add("bath", rectangle(0, 0, 4, 4));
  add("an open line", "4 4 10 4\n");
  input.unit = LengthUnit{"m", Rational(1)};
  const Rooms found = rooms(input, arrange(input));
  REQUIRE(found.rooms.size() == 3);
  CHECK(found.rooms[0].names == Names{"bath", "flat"});
  CHECK(found.rooms[1].names == Names{"flat"});
  CHECK(found.rooms[2].names == Names{"flat"});
}

TEST_CASE("layers that bound a room are named, and doors on them") {
  SegmentSet input = segments(rectangle(0, 0, 4, 4) + "2 0 2 3\n");
  Source door;
  door.layer = "A-DOOR";
  input.add(Segment{{2, 3}, {2, 4}}, input.add_source(door));
  input.unit = LengthUnit{"m", Rational(1)};
  const Rooms found = rooms(input, arrange(input));
  REQUIRE(found.rooms.size() == 2);
  CHECK(found.rooms[0].layers == Names{"A-DOOR"});
  CHECK(found.rooms[0].neighbours == std::vector<RoomNeighbour>{{1, 4, 0, true}});
}

TEST_CASE("rooms are the same in a drawing that is turned, mirrored and moved") {
  const std::string plan = rectangle(0, 0, 4, 3) + rectangle(4, 0, 9, 5) + rectangle(5, 1, 8, 4);
  const Rooms before = Plan(plan).text("a", 1, 1).text("b", 6, 3).rooms();
  Plan moved(plan);
  moved.text("a", 1, 1).text("b", 6, 3);
  const auto map = [](const Point& p) -> Point { return {100 - p.y, 7 + p.x}; };
  SegmentSet input;
  const SourceId source = input.add_source({});
  for (const Segment& s : moved.input.segments) input.add(Segment{map(s.a), map(s.b)}, source);
  for (const Label& label : moved.input.labels) {
    input.labels.push_back({source, label.text, map(*label.place)});
  }
  input.unit = moved.input.unit;
  const Rooms after = rooms(input, arrange(input));
  REQUIRE(before.rooms.size() == 3);
  REQUIRE(after.rooms.size() == 3);
  for (const Room& room : before.rooms) {
    const auto same = [&](const Room& other) {
      return other.names == room.names && other.area == room.area &&
             other.gross_area == room.gross_area && other.perimeter == room.perimeter;
    };
    CHECK(std::any_of(after.rooms.begin(), after.rooms.end(), same));
  }
  CHECK(before.rooms[2].parent == 1);
}

TEST_CASE("negative sizes are refused") {
  RoomOptions options;
  options.min_width = -1;
  CHECK_THROWS_AS(Plan(rectangle(0, 0, 1, 1)).rooms(options), Error);
}

TEST_CASE("the largest circle in a polygon") {
  using rooms_steps::inscribed_circle;
  SECTION("a rectangle: half the shorter side") {
    const auto circle = inscribed_circle(polygon({{0, 0}, {10, 0}, {10, 3}, {0, 3}}), 0);
    CHECK(circle.radius == Approx(1.5).epsilon(0.02));
    CHECK(circle.centre == PointD{5, 1.5});
  }
  SECTION("whose sides run in any direction") {
    const std::vector<SegmentD> sides{{{0, 0}, {8, 4}}, {{0, 8}, {8, 4}}, {{0, 0}, {0, 8}}};
    CHECK(inscribed_circle(sides, 0).radius ==
          Approx(64 / (8 + 2 * std::sqrt(80.0))).epsilon(0.02));  // 2 area / perimeter
  }
  SECTION("a very long strip, in some thousand squares") {
    CHECK(inscribed_circle(polygon({{0, 0}, {1e9, 0}, {1e9, 1}, {0, 1}}), 0).radius <= 0.5);
  }
  SECTION("a right triangle: (a + b - c) / 2") {
    const auto circle = inscribed_circle(polygon({{0, 0}, {4, 0}, {0, 3}}), 0);
    CHECK(circle.radius == Approx(1).epsilon(0.02));
  }
  SECTION("sides may run either way, as edges do: from left to right") {
    const auto circle = inscribed_circle({{{0, 0}, {0, 3}}, {{0, 0}, {4, 0}}, {{0, 3}, {4, 0}}}, 0);
    CHECK(circle.radius == Approx(1).epsilon(0.02));
  }
  SECTION("a regular polygon: the apothem") {
    std::vector<PointD> points;
    for (int i = 0; i < 12; ++i) {
      const double angle = i * std::numbers::pi / 6;
      points.push_back({1e6 + 5 * std::cos(angle), 5 * std::sin(angle)});
    }
    CHECK(inscribed_circle(polygon(points), 0).radius ==
          Approx(5 * std::cos(std::numbers::pi / 12)).epsilon(0.02));
  }
  SECTION("a ring between two squares: half its width at a corner's bisector") {
    auto sides = polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    const auto hole = polygon({{1, 1}, {1, 9}, {9, 9}, {9, 1}});
    sides.insert(sides.end(), hole.begin(), hole.end());
    // It touches two outer sides and the inner corner: r + r sqrt 2 = sqrt 2.
    CHECK(inscribed_circle(sides, 0).radius ==
          Approx(std::numbers::sqrt2 / (1 + std::numbers::sqrt2)).epsilon(0.02));
  }
  SECTION("a sliver far from the origin, narrower than doubles are apart there") {
    const double x = 1e6, next = std::nextafter(x, 2e6);
    CHECK(inscribed_circle(polygon({{x, 0}, {next, 0}, {next, 3}}), 0).radius < 1e-9);
    CHECK(inscribed_circle(polygon({{x, 0}, {next, 1}, {next, 3}}), 0.1).radius == 0);
  }
  SECTION("nothing that is narrower than what is asked for is looked into") {
    const auto circle = inscribed_circle(polygon({{0, 0}, {1000, 0}, {1000, 0.1}, {0, 0.1}}), 1);
    CHECK(circle.radius < 1);
  }
}

TEST_CASE("lines of chosen layers alone, with what belongs to them") {
  SegmentSet input;
  const auto add = [&](const std::string& layer, const std::string& lines, bool is_ring) {
    Source source;
    source.layer = layer;
    const SourceId id = input.add_source(source);
    const auto first = static_cast<std::uint32_t>(input.segments.size());
    for (const Segment& s : segments(lines).segments) input.add(s, id);
    const auto count = static_cast<std::uint32_t>(input.segments.size()) - first;
    if (is_ring) input.rings.push_back({first, count, RingRole::Polygon});
    input.labels.push_back({id, layer, Point{1, 1}});
  };
  add("Furniture", rectangle(1, 1, 2, 2), true);
  add("Walls", rectangle(0, 0, 4, 4), true);
  add("Walls inside", "2 0 2 4\n", false);
  input.rounding = {0, 0, 0, 0, 1, 1, 1, 1, 2};
  const SegmentSet walls = on_layers(input, {"wall*"});
  CHECK(walls.segments.size() == 5);
  CHECK(walls.rounding == std::vector<double>{1, 1, 1, 1, 2});
  CHECK(walls.rings == std::vector<Ring>{{0, 4, RingRole::Polygon}});
  CHECK(walls.labels == input.labels);
  CHECK(walls.sources[walls.segment_source[4]].layer == "Walls inside");
  CHECK(on_layers(input, {"*"}).segments == input.segments);
  CHECK_THROWS_WITH(on_layers(input, {"Walls", "Doors"}),
                    Catch::Matchers::Contains(R"("Furniture", "Walls", "Walls inside")"));
}

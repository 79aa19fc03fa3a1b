// Regions, their expressions and their polygons, exactly.

#include "plumbline/regions.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <random>

#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "plumbline/rings.hpp"

using namespace plumbline;

namespace {

using Corners = std::vector<std::array<int, 2>>;

/// A drawing of named rings, each closed, each a region of its own.
struct Drawing {
  SegmentSet input;
  std::vector<Region> regions;

  void add(const std::string& name, const Corners& corners, FillRule rule = FillRule::NonZero) {
    Region region{name, rule, {}};
    const SourceId source = input.add_source({});
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto& [ax, ay] = corners[i];
      const auto& [bx, by] = corners[(i + 1) % corners.size()];
      region.segments.emplace_back(input.segments.size());
      input.add(Segment{{ax, ay}, {bx, by}}, source);
    }
    regions.push_back(std::move(region));
  }
  void square(const std::string& name, int x, int y, int side, FillRule rule = FillRule::NonZero) {
    add(name, {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, rule);
  }
};

struct Labelled {
  ExactComplex complex;
  LabelledComplex labelled;

  explicit Labelled(const Drawing& drawing)
      : complex(arrange(drawing.input)), labelled(label(drawing.input, complex, drawing.regions)) {}
  FaceSet faces(const std::string& expression) const { return select(labelled, expression); }
  Rational area(const std::string& expression) const {
    return plumbline::area(complex, faces(expression));
  }
};

std::string message_of(const Labelled& of, const std::string& expression) {
  try {
    of.faces(expression);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// How many unit squares with corners on the grid an expression of rectangles covers.
struct Rectangle {
  std::string name;
  int x0, y0, x1, y1;
  bool covers(int x, int y) const { return x0 <= x && x < x1 && y0 <= y && y < y1; }
};

std::vector<Rectangle> random_rectangles(std::mt19937& random, int count, int size) {
  std::uniform_int_distribution<int> place(0, size), name(0, 2);
  std::vector<Rectangle> result;
  while (result.size() < static_cast<std::size_t>(count)) {
    const int x0 = place(random), y0 = place(random), x1 = place(random), y1 = place(random);
    if (x0 == x1 || y0 == y1) continue;
    result.push_back({std::string(1, static_cast<char>('A' + name(random))), std::min(x0, x1),
                      std::min(y0, y1), std::max(x0, x1), std::max(y0, y1)});
  }
  for (const char c : {'A', 'B', 'C'}) result.push_back({std::string(1, c), 0, 0, 1, 1});
  return result;
}

Drawing drawn(const std::vector<Rectangle>& rectangles, std::mt19937& random) {
  Drawing result;
  for (const auto& r : rectangles) {
    Corners corners = {{r.x0, r.y0}, {r.x1, r.y0}, {r.x1, r.y1}, {r.x0, r.y1}};
    if (random() % 2 == 0) std::reverse(corners.begin(), corners.end());
    result.add(r.name, corners);
  }
  return result;
}

/// The drawing that the edges of a complex are.
SegmentSet edges_of(const ExactComplex& complex) {
  SegmentSet result;
  const SourceId source = result.add_source({});
  for (const Edge& e : complex.edges) {
    result.add(Segment{complex.vertices[e.tail], complex.vertices[e.head]}, source);
  }
  return result;
}

}  // namespace

TEST_CASE("two squares that overlap have the areas of the textbook") {
  Drawing drawing;
  drawing.square("A", 0, 0, 2);
  drawing.square("B", 1, 1, 2);
  const Labelled of(drawing);
  CHECK(of.area("A") == 4);
  CHECK(of.area("A & B") == 1);
  CHECK(of.area("A | B") == 7);
  CHECK(of.area("A - B") == 3);
  CHECK(of.area("A ^ B") == 6);
  CHECK(of.area("count >= 2") == 1);
  CHECK(of.area("count = 1") == 6);
  CHECK(of.area("A & !B") == 3);
  CHECK(of.area("A - (B | A)") == 0);
}

TEST_CASE("two triangles with a side in common do not overlap") {
  // GEOS #1525: cleaning the coverage gave areas of 6 and 0.
  Drawing drawing;
  drawing.add("A", {{1, 0}, {1, 1}, {1, 3}, {4, 0}});
  drawing.add("B", {{0, 4}, {1, 3}, {1, 0}});
  const Labelled of(drawing);
  CHECK(of.area("A") == Rational(9, 2));
  CHECK(of.area("B") == Rational(3, 2));
  CHECK(of.area("A & B") == 0);
  CHECK(of.area("A | B") == 6);
}

TEST_CASE("a pentagram has its core by every rule but evenodd") {
  const Corners star = {{0, 10}, {6, -8}, {-10, 3}, {10, 3}, {-6, -8}};
  const auto core_is_in = [&](FillRule rule, bool turned) {
    Drawing drawing;
    Corners corners = star;
    if (turned) std::reverse(corners.begin(), corners.end());
    drawing.add("star", corners, rule);
    const Labelled of(drawing);
    const FaceSet faces = of.faces("star");
    return static_cast<bool>(faces[locate(of.complex, {0, 0})]);
  };
  CHECK_FALSE(core_is_in(FillRule::EvenOdd, false));
  CHECK(core_is_in(FillRule::NonZero, false));
  CHECK(core_is_in(FillRule::NonZero, true));
  CHECK(core_is_in(FillRule::Positive, true) != core_is_in(FillRule::Positive, false));
  CHECK(core_is_in(FillRule::Negative, true) == core_is_in(FillRule::Positive, false));
}

TEST_CASE("a ring drawn twice is nothing by evenodd and itself by nonzero") {
  for (const auto& [rule, expected] : {std::pair{FillRule::EvenOdd, 0}, {FillRule::NonZero, 9}}) {
    Drawing drawing;
    drawing.square("A", 0, 0, 3, rule);
    drawing.square("A", 0, 0, 3, rule);
    Region both{"both", rule, drawing.regions[0].segments};
    both.segments.insert(both.segments.end(), drawing.regions[1].segments.begin(),
                         drawing.regions[1].segments.end());
    drawing.regions = {both};
    CHECK(Labelled(drawing).area("both") == expected);
  }
}

TEST_CASE("rectangles on a grid cover the unit squares that counting gives") {
  std::mt19937 random(7);
  constexpr int kSize = 9;
  const auto has = [](const std::vector<Rectangle>& all, char name, int x, int y) {
    return std::any_of(all.begin(), all.end(),
                       [&](const Rectangle& r) { return r.name[0] == name && r.covers(x, y); });
  };
  for (int round = 0; round < 60; ++round) {
    const auto all = random_rectangles(random, 1 + round % 12, kSize);
    const Labelled of(drawn(all, random));
    std::array<int, 5> counted{};
    for (int x = 0; x < kSize; ++x) {
      for (int y = 0; y < kSize; ++y) {
        const bool a = has(all, 'A', x, y), b = has(all, 'B', x, y), c = has(all, 'C', x, y);
        const auto n = std::count_if(all.begin(), all.end(),
                                     [&](const Rectangle& r) { return r.covers(x, y); });
        counted[0] += a && !(b || c);
        counted[1] += (a || b) != c;
        counted[2] += n >= 3;
        counted[3] += (a && b) || c;
        counted[4] += !a && (b || c);
      }
    }
    CHECK(of.area("A - (B | C)") == counted[0]);
    CHECK(of.area("(A | B) ^ C") == counted[1]);
    CHECK(of.area("count >= 3") == counted[2]);
    CHECK(of.area("A & B | C") == counted[3]);
    CHECK(of.area("!A & (B | C)") == counted[4]);
  }
}

TEST_CASE("laws of sets hold to the last digit on slanted drawings") {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> place(-50, 50), count(3, 7);
  for (int round = 0; round < 40; ++round) {
    Drawing drawing;
    for (const char* name : {"A", "B", "C", "A"}) {
      Corners corners;
      for (int i = count(random); i > 0; --i) corners.push_back({place(random), place(random)});
      drawing.add(name, corners, round % 2 == 0 ? FillRule::EvenOdd : FillRule::NonZero);
    }
    const Labelled of(drawing);
    CHECK(of.area("A | B") + of.area("A & B") == of.area("A") + of.area("B"));
    CHECK(of.faces("!(A | B)") == of.faces("!A & !B"));
    CHECK(of.faces("A - (B | C)") == of.faces("A - B - C"));
    CHECK(of.area("A ^ A") == 0);
    CHECK(of.faces("(A ^ B) ^ B") == of.faces("A"));
    CHECK(of.faces("A | B | C") == of.faces("count > 0"));
  }
}

TEST_CASE("faces joined are the arrangement of the edges that are left") {
  std::mt19937 random(3);
  for (int round = 0; round < 60; ++round) {
    const Drawing drawing = drawn(random_rectangles(random, 2 + round % 9, 12), random);
    const Labelled of(drawing);
    const FaceSet chosen = of.faces("A - B | C");
    const RegionPolygons made = region_polygons(of.complex, chosen);
    CHECK(validate(made.complex).empty());
    CHECK(signature(made.complex) == signature(arrange(edges_of(made.complex))));
    Rational sum = 0;
    for (const Rational& area : made.areas) sum += area;
    CHECK(sum == area(of.complex, chosen));
    const auto sides = boundary(of.complex, chosen);
    CHECK(static_cast<std::size_t>(std::count_if(sides.begin(), sides.end(), [](int s) {
            return s != 0;
          })) == made.complex.edge_count());
  }
}

TEST_CASE("squares that touch in a corner are two polygons, a frame is one with a hole") {
  Drawing drawing;
  drawing.square("A", 0, 0, 1);
  drawing.square("A", 1, 1, 1);
  const Labelled touching(drawing);
  CHECK(region_polygons(touching.complex, touching.faces("A")).polygons.size() == 2);

  Drawing frame;
  frame.square("out", 0, 0, 3);
  frame.square("in", 1, 1, 1);
  const Labelled of(frame);
  const RegionPolygons made = region_polygons(of.complex, of.faces("out - in"));
  REQUIRE(made.polygons.size() == 1);
  CHECK(made.polygons[0].holes.size() == 1);
  CHECK(made.areas[0] == 8);
}

TEST_CASE("regions within each other take room for their edges alone") {
  Drawing drawing;
  constexpr int kCount = 2000;
  for (int i = 0; i < kCount; ++i) drawing.square("A", i, i, 2 * (kCount - i) + 1);
  const Labelled of(drawing);
  CHECK(of.labelled.changes.flat().size() == of.complex.face_count() - 1);
  CHECK(of.area("count >= 2000") == 9);
}

TEST_CASE("the set of a face is the same number by whichever way it is reached") {
  std::mt19937 random(5);
  const Labelled of(drawn(random_rectangles(random, 9, 8), random));
  const Lists<RegionId> sets = regions_of_faces(of.labelled);
  std::map<std::vector<RegionId>, Membership::SetKey> keys;
  for_each_face(of.labelled, [&](FaceId f, const Membership& m) {
    const std::vector<RegionId> set(sets[f].begin(), sets[f].end());
    CHECK(m.count() == set.size());
    const auto [found, is_new] = keys.try_emplace(set, m.key());
    CHECK(found->second == m.key());
  });
  CHECK(keys.size() > 5);
}

TEST_CASE("a layer has its polygons, and what its other lines close") {
  SegmentSet input;
  const auto add = [&](const std::string& layer, const Corners& corners, bool is_closed) {
    Source source;
    source.layer = layer;
    const SourceId id = input.add_source(source);
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < corners.size(); ++i) {
      const auto& [ax, ay] = corners[i];
      const auto& [bx, by] = corners[(i + 1) % corners.size()];
      input.add(Segment{{ax, ay}, {bx, by}}, id);
    }
  };
  const Corners outer{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, inner{{3, 3}, {6, 3}, {6, 6}, {3, 6}};
  input.rings.push_back({0, 4, RingRole::Polygon});
  add("polygons", outer, true);
  add("walls", outer, true);
  add("walls", inner, true);
  add("walls", {{20, 0}, {30, 0}, {30, 5}}, false);
  add("walls", {{9, 9}, {6, 6}}, false);  // makes of the frame a line work with odd ends
  add("beams", {{40, 0}, {50, 0}, {40, 1}}, true);
  const LayerRegions found = layer_regions(input, FillRule::NonZero);
  REQUIRE(found.regions.size() == 2);
  CHECK(found.regions[0].name == "polygons");
  CHECK(found.regions[0].rule == FillRule::NonZero);
  CHECK(found.regions[1].name == "beams");
  CHECK(found.open.size() == 4 + 4 + 2 + 1);
  input.segments.truncate(14);  // without the line that joins outer and inner
  const LayerRegions frame = layer_regions(input, FillRule::NonZero);
  REQUIRE(frame.regions.size() == 2);
  CHECK(frame.regions[1].name == "walls");
  CHECK(frame.open == std::vector{SegmentId(12), SegmentId(13)});
  const ExactComplex complex = arrange(input);
  const LabelledComplex labelled = label(input, complex, frame.regions);
  CHECK(area(complex, select(labelled, "walls")) == 81 - 9);
  CHECK(area(complex, select(labelled, "polygons - walls")) == 9);
}

TEST_CASE("what is no region and no expression is said with its place") {
  Drawing drawing;
  drawing.square("A-WALL", 0, 0, 2);
  drawing.square("B", 1, 1, 2);
  const Labelled of(drawing);
  CHECK(of.area("'A-WALL' & B") == 1);
  CHECK(of.area("A* & B") == 1);
  CHECK(message_of(of, "A & B") ==
        "no region has this name; there are A-WALL, B (in quotation marks where a name has - or "
        "spaces): \"A & B\"");
  CHECK_FALSE(message_of(of, "B &").empty());
  CHECK_FALSE(message_of(of, "(B").empty());
  CHECK_FALSE(message_of(of, "B B").empty());
  CHECK_FALSE(message_of(of, "count > x").empty());
  CHECK_FALSE(message_of(of, "count ~ 1").empty());
  CHECK_FALSE(message_of(of, "").empty());
  CHECK_FALSE(message_of(of, "'B").empty());

  drawing.regions[1].segments.pop_back();
  const ExactComplex complex = arrange(drawing.input);
  CHECK_THROWS_WITH(label(drawing.input, complex, drawing.regions),
                    Catch::Contains("not closed at (1 1)"));
}

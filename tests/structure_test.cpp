#include "plumbline/structure.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <random>

#include "plumbline/error.hpp"
#include "support/listing.hpp"

using plumbline::Affine;
using plumbline::evaluate;
using plumbline::Model;
using plumbline::parse_decimal;
using plumbline::Point;
using plumbline::Rational;
using plumbline::scaling;
using plumbline::Struct;
using plumbline::StructId;
using plumbline::Structure;
using plumbline::translation;

namespace {

Point point(const std::string& text) {
  const auto blank = text.find(' ');
  return {parse_decimal(text.substr(0, blank)), parse_decimal(text.substr(blank + 1))};
}

/// The segment "ax ay, bx by" as a model.
Model model(const std::string& text, const std::string& id = "") {
  const auto comma = text.find(", ");
  plumbline::Source source;
  source.id = id;
  return {source, {{point(text.substr(0, comma)), point(text.substr(comma + 2))}}, {}};
}

Structure structure_of(std::vector<Struct> structs) {
  Structure structure;
  structure.structs = std::move(structs);
  structure.root = StructId(0);
  return structure;
}

}  // namespace

TEST_CASE("a map applies to all that follows it in the same body, the last one first") {
  CHECK(listing(structure_of({{"root",
                               "",
                               {model("0 0, 1 0"), translation(10, 0), model("0 0, 1 0"),
                                scaling(2, 2), model("0 0, 1 0"), StructId(1)}},
                              {"inner", "", {translation(0, 1), model("0 0, 1 0", "deep")}}})) ==
        "0 0, 1 0 | \n"
        "10 0, 11 0 | \n"
        "10 0, 12 0 | \n"
        "10 2, 12 2 | #deep (inner)\n");
}

TEST_CASE("a map in a sub-structure ends with it") {
  CHECK(listing(structure_of({{"", "", {StructId(1), model("0 0, 1 0")}},
                              {"", "", {translation(5, 5), model("0 0, 1 0")}}})) ==
        "5 5, 6 5 | \n"
        "0 0, 1 0 | \n");
}

TEST_CASE("a shared structure appears once for each reference, under its path of names") {
  CHECK(listing(structure_of({{"root", "", {StructId(1), translation(0, 3), StructId(1)}},
                              {"flat", "", {StructId(2), StructId(3)}},
                              {"", "", {model("0 0, 1 0", "a")}},
                              {"room", "", {model("0 1, 1 1", "b")}}})) ==
        "0 0, 1 0 | #a (flat)\n"
        "0 1, 1 1 | #b (flat/room)\n"
        "0 3, 1 3 | #a (flat)\n"
        "0 4, 1 4 | #b (flat/room)\n");
}

TEST_CASE("a segment that a map shrinks to nothing is rejected with its source") {
  CHECK(listing(structure_of({{"", "", {scaling(0, 1), StructId(1)}},
                              {"g", "", {model("1 2, 3 2", "w"), model("1 2, 3 4", "v")}}})) ==
        "0 2, 0 4 | #v (g)\n"
        "rejected:\n"
        "#w (g): zero-length segment: 0 2, 0 2\n");
}

TEST_CASE("what the reader refused and replaced is carried over") {
  Structure structure = structure_of({{}});
  structure.files = {"a.svg"};
  structure.rejected = {
      {{0, 2, 3, "text", "", ""}, "element text is not understood yet", "<text>"}};
  structure.ledger = {{{0, 2, 3, "g", "", ""}, "rotate(30)", "1e-15 rad"}};
  const auto set = evaluate(structure);
  CHECK(set.files == structure.files);
  CHECK(set.rejected == structure.rejected);
  CHECK(set.ledger == structure.ledger);
}

TEST_CASE("decimals are mapped as rationals are, where they outgrow machine integers too") {
  std::mt19937_64 random(12);
  const auto number = [&] {
    const auto mantissa = static_cast<std::int64_t>(random() >> (1 + random() % 63));
    const int digits = static_cast<int>(random() % 19);
    const Rational value = plumbline::Number::decimal(mantissa, digits).rational();
    return random() % 20 == 0 ? Rational(value / 3) : Rational(random() % 2 == 0 ? value : -value);
  };
  const auto entry = [&] { return random() % 3 == 0 ? Rational(0) : number(); };
  for (int i = 0; i < 5000; ++i) {
    const std::array<Rational, 6> e{number(), entry(), entry(), number(), entry(), entry()};
    const Affine map{e[0], e[1], e[2], e[3], e[4], e[5]};
    const plumbline::Segment segment{{number(), number()}, {number(), number()}};
    const auto set = evaluate(structure_of({{"", "", {map, Model{{}, {segment}, {}}}}}));
    if (set.segments.empty()) continue;  // mapped to one point
    for (const auto& [p, image] :
         {std::pair(segment.a, set.segments[0].a), {segment.b, set.segments[0].b}}) {
      REQUIRE(image.x == e[0] * p.x + e[2] * p.y + e[4]);
      REQUIRE(image.y == e[1] * p.x + e[3] * p.y + e[5]);
    }
  }
}

TEST_CASE("the rows of a model are elements of their own") {
  Model table = model("0 0, 1 0", "t");
  table.segments.push_back({point("5 5"), point("5 5")});
  table.segments.push_back({point("0 0"), point("0 1")});
  table.source.element = "row";
  table.rows = {{3, 1}, {4, 2}, {6, 1}};
  CHECK(listing(structure_of({{"", "", {table}}})) ==
        "0 0, 1 0 | line 3:1 row #t\n"
        "0 0, 0 1 | line 6:1 row #t\n"
        "rejected:\n"
        "line 4:2 row #t: zero-length segment: 5 5, 5 5\n");
  table.rows.pop_back();
  CHECK_THROWS_AS(evaluate(structure_of({{"", "", {table}}})), plumbline::Error);

  table.rows = {{3, 1, 2, 1}, {6, 1, 0, 2}, {7, 1}};
  CHECK_THROWS_AS(evaluate(structure_of({{"", "", {table}}})), plumbline::Error);
  table.row_ids = {"wall", "nothing"};
  CHECK(listing(structure_of({{"", "", {table}}})) ==
        "0 0, 1 0 | line 3:1 row #wall\n"
        "0 0, 0 1 | line 7:1 row #t\n"
        "rejected:\n"
        "line 3:1 row #wall: zero-length segment: 5 5, 5 5\n");
  table.rows[2].segment_count = 2;
  CHECK_THROWS_AS(evaluate(structure_of({{"", "", {table}}})), plumbline::Error);
}

TEST_CASE("a cycle of references is refused, its names given") {
  const auto cyclic = structure_of({{"root", "", {StructId(1)}},
                                    {"flat", "", {StructId(2)}},
                                    {"", "", {StructId(3)}},
                                    {"room", "", {StructId(1)}}});
  try {
    evaluate(cyclic);
    FAIL("no error");
  } catch (const plumbline::Error& error) {
    CHECK(std::string(error.what()) == "cycle of references: \"flat/Struct 2/room/flat\"");
    CHECK(error.code() == plumbline::ErrorCode::BadInput);
  }
}

TEST_CASE("a reference to no Struct is refused") {
  CHECK_THROWS_AS(evaluate(structure_of({{"", "", {StructId(1)}}})), plumbline::Error);
  CHECK_THROWS_AS(evaluate(Structure{}), plumbline::Error);
}

TEST_CASE("a million nested structures are evaluated and freed") {
  constexpr std::size_t kDepth = 1'000'000;
  Structure structure;
  structure.structs.resize(kDepth);
  for (std::size_t i = 0; i + 1 < kDepth; ++i) {
    structure.structs[i].name = "g";
    if (i % 1000 == 1) structure.structs[i].body.emplace_back(translation(1, 0));
    structure.structs[i].body.emplace_back(StructId(i + 1));
  }
  structure.structs.back().body.emplace_back(model("0 0, 0 1"));
  structure.root = StructId(0);
  const auto set = evaluate(structure);
  CHECK(to_text(set.segments.at(0)) == "1000 0, 1000 1");
  const std::string& path = set.sources.at(0).path;
  CHECK(path.size() <= plumbline::kMaxPathText + 4);
  CHECK(path.substr(path.size() - 6) == "/g/...");
}

TEST_CASE("a path that was cut short grows again from where it was") {
  const std::string longest(plumbline::kMaxPathText, 'x');
  CHECK(listing(structure_of({{"", "", {StructId(1)}},
                              {"a", "", {StructId(2), StructId(3)}},
                              {longest, "", {StructId(3)}},
                              {"c", "", {model("0 0, 1 0")}}})) ==
        "0 0, 1 0 | (a/...)\n"
        "0 0, 1 0 | (a/c)\n");
}

TEST_CASE("structures that multiply beyond the limit are refused, up to it they are not") {
  std::vector<Struct> doubling(41);
  for (std::size_t i = 0; i < 40; ++i) doubling[i].body = {StructId(i + 1), StructId(i + 1)};
  CHECK(evaluate(structure_of(doubling)).segments.empty());  // 2^40 times nothing
  doubling.back().body = {model("0 0, 1 0")};
  CHECK(instance_count(structure_of(doubling)) == std::uint64_t{1} << 40U);
  CHECK(box(structure_of(doubling))->high[0].rational() == 1);
  CHECK_THROWS_AS(evaluate(structure_of(doubling), {10'000'000}), plumbline::Error);
  // One item, and four integer coordinates of which one is 0: numerator and denominator each.
  const auto one = structure_of({{"", "", {model("1 1, 0 2")}}});
  CHECK_NOTHROW(evaluate(one, {1 + 7}));
  CHECK_THROWS_AS(evaluate(one, {1 + 6}), plumbline::Error);
}

TEST_CASE("more segments than allowed are refused before they are made, just as many are not") {
  std::vector<Struct> doubling(41);
  for (std::size_t i = 0; i < 40; ++i) doubling[i].body = {StructId(i + 1), StructId(i + 1)};
  doubling.back().body = {model("0 0, 1 0")};
  plumbline::EvaluateOptions options;
  options.max_segments = 1000;
  CHECK_THROWS_WITH(evaluate(structure_of(doubling), options), "more than 1000 segments");
  plumbline::ToLarOptions to_lar;
  to_lar.max_cells = 1000;
  CHECK_THROWS_WITH(struct_to_lar(structure_of(doubling), to_lar),
                    "more than 1000 segments or cells");
  const auto four = structure_of(
      {{"", "", {StructId(1), StructId(1)}}, {"", "", {model("0 0, 1 0"), model("0 0, 0 1")}}});
  options.max_segments = to_lar.max_cells = 4;
  CHECK(evaluate(four, options).segments.size() == 4);
  CHECK_NOTHROW(struct_to_lar(four, to_lar));
  options.max_segments = to_lar.max_cells = 3;
  CHECK_THROWS_AS(evaluate(four, options), plumbline::Error);
  CHECK_THROWS_AS(struct_to_lar(four, to_lar), plumbline::Error);
}

TEST_CASE("nested maps that make monstrous numbers are refused") {
  std::vector<Struct> growing(100'000);
  for (std::size_t i = 0; i + 1 < growing.size(); ++i) {
    growing[i].body = {scaling(parse_decimal("1.1e4000"), 1), StructId(i + 1)};
  }
  growing.back().body = {model("0 0, 1 0")};
  try {
    evaluate(structure_of(growing));
    FAIL("no error");
  } catch (const plumbline::Error& error) {
    CHECK(error.code() == plumbline::ErrorCode::Limit);
  }
}

TEST_CASE("a million instances are walked one by one") {
  Structure structure = structure_of({{"plan", "", {}}, {"row", "", {}}, {"room", "", {}}});
  structure.structs[2].body = {model("0 0, 1 0")};
  for (std::size_t i = 0; i < 1000; ++i) {
    structure.structs[0].body.emplace_back(StructId(1));
    structure.structs[0].body.emplace_back(translation(0, 3));
    structure.structs[1].body.emplace_back(StructId(2));
    structure.structs[1].body.emplace_back(translation(4, 0));
  }
  CHECK(instance_count(structure) == 1'000'000);
  std::size_t count = 0;
  plumbline::Traversal walk(structure);
  while (walk.next()) ++count;
  CHECK(count == 1'000'000);
  CHECK_FALSE(walk.next());
  const auto found = box(structure);
  REQUIRE(found);
  CHECK(found->high[0].rational() == 999 * 4 + 1);
  CHECK(found->high[1].rational() == 999 * 3);
}

TEST_CASE("a filter keeps what stands within a category, where it was") {
  const auto plan =
      structure_of({{"plan", "", {model("9 9, 8 8"), translation(10, 0), StructId(1)}},
                    {"walls", "layer", {translation(1, 0), model("0 0, 1 0"), StructId(2)}},
                    {"doors", "", {model("0 0, 0 1")}}});
  CHECK(listing(filter(plan, "layer")) ==
        "11 0, 12 0 | (walls)\n"
        "11 0, 11 1 | (walls/doors)\n");
  CHECK(listing(filter(plan, "no such")).empty());
  CHECK(listing(filter(filter(plan, "layer"), "layer")) == listing(filter(plan, "layer")));
}

TEST_CASE("a structure of space has no segments in the plane") {
  try {
    evaluate(structure_of({{"", "", {plumbline::cuboids({1, 1, 1})}}}));
    FAIL("no error");
  } catch (const plumbline::Error& error) {
    CHECK(std::string(error.what()).find("dimension 3") != std::string::npos);
  }
}

TEST_CASE("mixed dimensions are refused, both elements named") {
  const auto mixed = structure_of(
      {{"plan", "", {plumbline::Affine(3), StructId(1)}}, {"room", "", {model("0 0, 1 0")}}});
  try {
    dimension(mixed);
    FAIL("no error");
  } catch (const plumbline::Error& error) {
    CHECK(std::string(error.what()) ==
          "mixed dimensions: a model of dimension 2 (item 1 of room) and a map of dimension 3 "
          "(item 1 of plan)");
  }
}

TEST_CASE("vertices are identified exactly, or after rounding half away from zero") {
  const auto near = structure_of({{"", "", {model("0 0, 1/3 1"), model("0.33333 1, -0.00005 0")}}});
  CHECK(struct_to_lar(near).vertex_count() == 4);
  const auto rounded = struct_to_lar(near, {4, false});
  CHECK(rounded.vertex_count() == 3);
  CHECK(rounded.coordinates.back() == plumbline::Number());
  CHECK(rounded.coordinates[4] == plumbline::Number::decimal(-1, 4));  // -0.00005
  CHECK(struct_to_lar(near, {3, false}).vertex_count() == 2);
  CHECK_THROWS_AS(struct_to_lar(near, {-1, false}), plumbline::Error);
}

TEST_CASE("boxes that would need too many maps are refused, Structs without models cost none") {
  std::vector<Struct> chain(40);
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    chain[i].body = {StructId(i + 1), scaling(Rational(static_cast<long>(2 * i + 3)), 1),
                     StructId(i + 1)};
  }
  CHECK_FALSE(box(structure_of(chain)));
  chain.back().body = {model("0 0, 1 0")};
  CHECK_THROWS_AS(box(structure_of(chain)), plumbline::Error);
}

TEST_CASE("embedding changes no cells of a mixed structure") {
  plumbline::LarModel square = plumbline::cuboids({1, 1}, true);
  square.cells.pop_back();
  const auto mixed = structure_of({{"", "", {square, model("5 5, 6 6")}}});
  const auto flat = struct_to_lar(mixed);
  const auto space = struct_to_lar(embed(mixed, 1));
  CHECK(flat.cells[1].size() == 5);
  CHECK(space.cells == flat.cells);
}

TEST_CASE("labels are placed as segments are, and lie on the innermost layer") {
  Model wall = model("0 0, 1 0");
  wall.labels = {{"Kitchen", plumbline::NumberPoint{parse_decimal("0.5"), Rational(2)}},
                 {"a name", {}}};
  Structure structure = structure_of({{"", "", {StructId(1)}},
                                      {"outer", "layer", {translation(10, 0), StructId(2), wall}},
                                      {"group", "", {scaling(2, 2), StructId(3)}},
                                      {"inner", "layer", {wall}}});
  structure.unit = plumbline::LengthUnit{"mm", Rational(1, 1000)};
  structure.layers = {{"inner", 0xff0000, true}};
  const plumbline::SegmentSet set = evaluate(structure);
  REQUIRE(set.labels.size() == 4);
  CHECK(set.labels[0].place == point("11 4"));
  CHECK(set.labels[2].place == point("10.5 2"));
  CHECK(set.labels[1].text == "a name");
  CHECK_FALSE(set.labels[1].place.has_value());
  CHECK(set.sources[set.labels[1].source].layer == "inner");
  CHECK(set.sources[set.labels[3].source].layer == "outer");
  CHECK(set.unit == structure.unit);
  CHECK(set.layers == structure.layers);
}

TEST_CASE("a row of a table has its own labels") {
  Model table = model("0 0, 1 0");
  table.segments.push_back(table.segments[0]);
  table.source.layer = "parcels";
  table.rows = {{1, 1, 1, 0}, {2, 1, 1, 0}};
  table.labels = {{"first", {}, 0}, {"second", {}, 1}, {"again", {}, 1}};
  const plumbline::SegmentSet set = evaluate(structure_of({{"", "", {table}}}));
  REQUIRE(set.labels.size() == 3);
  CHECK(set.sources[set.labels[0].source].line == 1);
  CHECK(set.sources[set.labels[2].source].line == 2);
  CHECK(set.sources[set.labels[2].source].layer == "parcels");
}

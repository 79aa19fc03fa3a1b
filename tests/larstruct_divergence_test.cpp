// The catalogue of docs/divergences.md, L: what the published larstruct module answers, as recorded
// (tests/data/larstruct.json, or by value), and what is right.

#include <catch2/catch.hpp>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "support/recorded.hpp"

using namespace plumbline;

namespace {

const rapidjson::Document& records() {
  static const rapidjson::Document document = recorded("larstruct.json");
  return document;
}

Structure structure_of(std::vector<Struct::Item> body) {
  Structure structure;
  structure.structs.push_back({"S", "", std::move(body)});
  structure.root = StructId(0);
  return structure;
}

std::string text(std::span<const Number> numbers) {
  std::string result;
  for (const Number& x : numbers) result += (result.empty() ? "" : " ") + exact_text(x.rational());
  return result;
}

std::string text(const std::optional<Box>& box) {
  return box ? text(box->low) + " .. " + text(box->high) : "none";
}

Rational quarter() { return parse_decimal("1.5707963267948966"); }

}  // namespace

TEST_CASE("L1: a negative rotation about a coordinate axis is the inverse of the positive one") {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<Rational, 3> forth{0, 0, 0}, back{0, 0, 0};
    forth[axis] = Rational(3, 5);
    back[axis] = Rational(-3, 5);
    const Affine turn = rotation_in_space(forth).map;
    CHECK(compose(turn, rotation_in_space(back).map) == Affine(3));
    CHECK_FALSE(turn == rotation_in_space(back).map);  // published: equal
  }
}

TEST_CASE("L2: quarter turns of space are exact") {
  const Affine turn = rotation_in_space({quarter(), 0, 0}).map;
  CHECK(text(turn.entries()) == "1 0 0 0 0 0 -1 0 0 1 0 0");  // published: cosine -4.4e-8
}

TEST_CASE("L3: the box of a nested structure is that of its vertices") {
  Structure structure = structure_of({rotation(45).map, StructId(1)});
  structure.structs.push_back({"square", "", {cuboids({1, 1})}});
  const auto found = box(structure);
  REQUIRE(found);
  const auto& published = records()["box-of-rotated-substructure"]["box"];
  CHECK(std::fabs(published[1][0].GetDouble() - published[0][0].GetDouble()) < 1e-15);
  CHECK(nearest_double(found->low[0]) == Approx(-std::sqrt(0.5)));
  CHECK(nearest_double(found->high[0]) == Approx(std::sqrt(0.5)));
  CHECK(sgn(found->low[1]) == 0);
  CHECK(nearest_double(found->high[1]) == Approx(std::sqrt(2)));
}

TEST_CASE("L4: a projection drops coordinates, the last ones") {
  CHECK(embed(cuboids({1, 1, 1}), -1).dimension == 2);  // published: 1
  CHECK(embed(cuboids({1, 1, 1}), -2).dimension == 1);
}

TEST_CASE("L5: structures of models are converted, whatever the models are") {
  for (const char* name : {"test05-Model-instances", "test08-dwelling-Model"}) {
    CHECK(std::string(records()[name]["errors"]["struct2lar"][0].GetString()) == "AttributeError");
  }
  Structure chairs = structure_of({cuboids({1, 1}), translation(1, 0), cuboids({1, 1})});
  CHECK(struct_to_lar(chairs).vertex_count() == 6);
}

TEST_CASE("L6, L10: a structure is embedded with its models, lines and maps") {
  Model wall;
  wall.segments.push_back({Number::decimal(5, 0), Number()}, {Number::decimal(6, 0), Number()});
  const Structure space = embed(structure_of({translation(2, 1), cuboids({1, 1}), wall}), 1);
  CHECK(dimension(space) == 3);
  CHECK(text(box(space)) == "2 1 0 .. 8 2 0");  // published: crash
  const LarModel model = struct_to_lar(space);
  CHECK(text(model.coordinates) == "2 1 0 2 2 0 3 1 0 3 2 0 7 1 0 8 1 0");
  CHECK(struct_to_lar(embed(space, -1)).dimension == 2);
}

TEST_CASE("L7: repeated cells are kept or merged, as asked") {
  const Structure twice = structure_of({cuboids({1, 1}), cuboids({1, 1})});
  const auto& published = records()["duplicate-cells"]["struct2lar"];
  CHECK(published["jan2015"]["CV"].Size() == 2);
  CHECK(published["nov2015"]["CV"].Size() == 1);
  CHECK(struct_to_lar(twice).cells[0].size() == 2);
  CHECK(struct_to_lar(twice, {std::nullopt, true}).cells[0].size() == 1);
  // Also with its vertices in another order, as a set of vertices.
  LarModel turned = cuboids({1, 1});
  turned.cells[0] = Cells();
  turned.cells[0].push_back(std::vector<std::uint32_t>{3, 2, 1, 0});
  const Structure other = structure_of({cuboids({1, 1}), turned});
  CHECK(struct_to_lar(other, {std::nullopt, true}).cells[0].size() == 1);
}

TEST_CASE("L8: edges of earlier models are kept") {
  LarModel square = cuboids({1, 1}, true);
  square.cells.pop_back();  // (V, FV, EV)
  const Structure mixed = structure_of({square, translation(2, 0), cuboids({1, 1})});
  CHECK_FALSE(records()["mixed-triple-then-pair"]["struct2lar"]["nov2015"].HasMember("EV"));
  const LarModel model = struct_to_lar(mixed);
  REQUIRE(model.cells.size() == 2);
  CHECK(model.cells[0].size() == 2);
  CHECK(model.cells[1].size() == 4);
}

TEST_CASE("L9: the empty structure is empty") {
  const Structure empty = structure_of({});
  CHECK(text(box(empty)) == "none");
  CHECK(dimension(empty) == 0);
  CHECK(struct_to_lar(empty).vertex_count() == 0);
  CHECK(evaluate(empty).segments.empty());
  const auto& errors = records()["empty-struct"]["errors"];
  CHECK(errors.HasMember("evalStruct"));
  // A map alone is as empty.
  CHECK(text(box(structure_of({translation(1, 1)}))) == "none");
}

TEST_CASE("L11: what follows a nested structure has the maps from before it") {
  // Letters of the published example as translations by powers of ten: A, (B, C, D), E.
  const LarModel point = lar_model(2, {0, 0}, {Cells()});
  const auto move = [](long x) { return translation(Rational(x), 0); };
  Structure structure = structure_of({point, move(1), StructId(1), move(10000), point});
  structure.structs.push_back({"list", "", {point, move(10), point, move(100), point, move(1000)}});
  std::string maps;
  for (Traversal t(structure); t.next();) maps += exact_text(t.map()(0, 2).rational()) + " ";
  CHECK(maps == "0 1 11 111 10001 ");  // published: the last one 11111
}

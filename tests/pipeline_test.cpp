// The whole way of real drawings, from the file to the exact complex.

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include "plumbline/plumbline.hpp"
#include "support/affine_image.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

const std::string kPlans[] = {"dwelling.svg", "hospital-emergency.svg", "hospital-ward.svg",
                              "office-plan.svg", "building.svg"};

Structure drawing(const std::string& name) {
  return read(std::string(PLUMBLINE_EXAMPLES) + "/" + name);
}

/// The drawing with a map in front of everything else in its root.
SegmentSet mapped(Structure structure, const Affine& map) {
  auto& body = structure.structs[structure.root].body;
  body.insert(body.begin(), map);
  return evaluate(structure);
}

}  // namespace

TEST_CASE("the exact complex of a real drawing keeps all invariants and covers the drawing") {
  const std::string name = GENERATE(from_range(std::begin(kPlans), std::end(kPlans)));
  CAPTURE(name);
  const SegmentSet input = evaluate(drawing(name));
  const ExactComplex complex = arrange(input);
  CHECK(to_text(validate(complex)) == "");
  CHECK(to_text(validate_coverage(complex, input)) == "");
  CHECK(input.ledger.empty());
  CHECK(arrange(input, ExactEngine::Cgal) == complex);
}

TEST_CASE("V, E and F of real drawings are those of an independent rational arrangement") {
  // Recorded from another program: all pairs of segments in Python's Fraction over the file's
  // decimals, tests/regressions/counts.py.
  const auto [name, expected] = GENERATE(table<std::string, std::string>({
      {"dwelling.svg", "V 33 E 39 F 8 C 1"},
      {"hospital-emergency.svg", "V 681 E 728 F 181 C 133"},
      {"hospital-ward.svg", "V 766 E 853 F 227 C 139"},
      {"office-plan.svg", "V 370 E 475 F 108 C 2"},
      {"building.svg", "V 576 E 876 F 303 C 2"},
  }));
  CHECK(summary(arrange(evaluate(drawing(name)))).substr(0, expected.size()) == expected);
}

TEST_CASE("a mapped drawing has the image of the drawing's complex") {
  const std::string name = GENERATE(from_range(std::begin(kPlans), std::end(kPlans)));
  const auto [what, map] = GENERATE(table<std::string, Affine>({
      {"mirrored", {-1, 0, 0, 1, 0, 0}},
      {"rotated by 90 degrees", {0, 1, -1, 0, 0, 0}},
      {"scaled by 1/3", {Rational(1, 3), 0, 0, Rational(1, 3), 0, 0}},
  }));
  CAPTURE(name, what);
  const ExactComplex complex = arrange(evaluate(drawing(name)));
  CHECK(signature(arrange(mapped(drawing(name), map))) == signature(affine_image(complex, map)));
}

TEST_CASE("a drawing shuffled, reversed and duplicated has the same complex") {
  const std::string name = GENERATE(from_range(std::begin(kPlans), std::end(kPlans)));
  CAPTURE(name);
  SegmentSet input = evaluate(drawing(name));
  const std::string expected = signature(arrange(input));
  std::mt19937 random(7);
  input.segments = shuffled(input.segments, random);
  CHECK(signature(arrange(input)) == expected);
  input.segments = reversed(input.segments);
  CHECK(signature(arrange(input)) == expected);
  input.segments = joined(input.segments, input.segments);
  CHECK(signature(arrange(input)) == expected);
}

TEST_CASE("a wall that ends short by less than its printed double tells still parts two rooms") {
  const auto file = std::filesystem::temp_directory_path() / "plumbline_joins_drift.lines";
  std::ofstream(file) << "0,0,4,0\n4,0,4,3\n4,3,0,3\n0,3,0,0\n2,0,2,2.9999999999999996\n";
  DrawingOptions options;
  CHECK(summary(exact_answer(file, options).complex).substr(0, 15) == "V 6 E 6 F 2 C 1");
  options.joins_drift = true;
  const Drawing joined = exact_answer(file, options);
  CHECK(summary(joined.complex).substr(0, 15) == "V 6 E 7 F 3 C 1");
  CHECK(joined.joined.places == 1);
  CHECK(rooms(joined.input, joined.complex).rooms.size() == 2);
  std::filesystem::remove(file);
}

TEST_CASE("a plan of 100 x 100 copies of a room keeps its rooms under any exact map") {
  // In doubles the plan rotated by 30 degrees has 48,382 faces: shared walls come apart.
  constexpr std::size_t kRooms = 100;
  Structure plan;
  plan.structs = {{"room", "", {cuboids({1, 1})}}, {"row", "", {}}, {"plan", "", {}}};
  plan.root = StructId(2);
  for (std::size_t i = 0; i < kRooms; ++i) {
    plan.structs[1].body.emplace_back(StructId(0));
    plan.structs[1].body.emplace_back(translation(1, 0));
    plan.structs[2].body.emplace_back(StructId(1));
    plan.structs[2].body.emplace_back(translation(0, 1));
  }
  const auto [what, map] = GENERATE(table<std::string, Affine>({
      {"as it is", Affine()},
      {"rotated by 30 degrees", rotation(30).map},
      {"mirrored, rotated by 17 degrees and scaled by 2/7",
       compose(rotation(17).map, scaling(Rational(-2, 7), Rational(2, 7)))},
  }));
  CAPTURE(what);
  const ExactComplex complex = arrange(mapped(plan, map));
  CHECK(complex.vertices.size() == (kRooms + 1) * (kRooms + 1));
  CHECK(complex.edge_count() == 2 * kRooms * (kRooms + 1));
  CHECK(complex.face_count() == kRooms * kRooms + 1);
  static const std::string upright = signature(arrange(evaluate(plan)));
  CHECK(signature(affine_image(complex, inverse(map))) == upright);
}

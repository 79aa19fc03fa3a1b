#include <algorithm>
#include <catch2/catch.hpp>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "support/dxf_text.hpp"
#include "support/listing.hpp"

using plumbline::dxf_with;
using plumbline::evaluate;
using plumbline::read_dxf;

namespace {

/// A section of blocks; each is "name base-x base-y entities".
std::string blocks(const std::vector<std::string>& definitions) {
  std::string text = "0 SECTION 2 BLOCKS ";
  for (const std::string& definition : definitions) {
    text += "0 BLOCK 2 " + definition + " 0 ENDBLK ";
  }
  return text + "0 ENDSEC";
}

/// The line from (1, 2) to (3, 5) on layer 0, so that no map of the plane hides.
const std::string kLine = "0 LINE 8 0 10 1 20 2 11 3 21 5";

std::string drawn(const std::string& inserts, const std::vector<std::string>& definitions) {
  return segments_of(evaluate(read_dxf(dxf_with(inserts, blocks(definitions)), "a.dxf")));
}

std::string error_of(const std::string& text) {
  try {
    evaluate(read_dxf(text, "a.dxf"));
  } catch (const plumbline::Error& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("an INSERT scales about the base point, then turns, then moves") {
  CHECK(drawn("0 INSERT 2 B 10 0 20 0", {"B 10 0 20 0 " + kLine}) == "1 2, 3 5\n");
  CHECK(drawn("0 INSERT 2 B 10 10 20 20", {"B 10 1 20 1 " + kLine}) == "10 21, 12 24\n");
  CHECK(drawn("0 INSERT 2 B 10 10 20 20 41 2 42 3", {"B 10 1 20 1 " + kLine}) == "10 23, 14 32\n");
  CHECK(drawn("0 INSERT 2 B 10 10 20 20 41 2 42 3 50 90", {"B 10 1 20 1 " + kLine}) ==
        "7 20, -2 24\n");
  CHECK(drawn("0 INSERT 2 b 10 10 20 20 41 -1", {"B 10 1 20 1 " + kLine}) == "10 21, 8 24\n");
}

TEST_CASE("an INSERT extruded towards -z is mirrored after it is placed") {
  CHECK(drawn("0 INSERT 2 B 10 10 20 20 50 90 210 0 220 0 230 -1", {"B 10 1 20 1 " + kLine}) ==
        "-9 20, -6 22\n");
}

TEST_CASE("an array repeats its block along its own axes, which its scale leaves alone") {
  CHECK(
      drawn("0 INSERT 2 B 10 0 20 0 41 2 42 2 70 2 71 3 44 10 45 100", {"B 10 1 20 2 " + kLine}) ==
      "0 0, 4 6\n10 0, 14 6\n0 100, 4 106\n10 100, 14 106\n0 200, 4 206\n10 200, 14 206\n");
  CHECK(drawn("0 INSERT 2 B 10 5 20 0 50 90 70 2 44 10", {"B 10 1 20 2 " + kLine}) ==
        "5 0, 2 2\n5 10, 2 12\n");
  CHECK(drawn("0 INSERT 2 B 10 0 20 0 70 3 71 3 44 10", {"B " + kLine}) ==
        "1 2, 3 5\n11 2, 13 5\n21 2, 23 5\n");
}

TEST_CASE("a huge array is refused, not expanded") {
  const auto structure =
      read_dxf(dxf_with("0 INSERT 2 B 10 0 20 0 70 1000000000 71 1000000000 44 1 45 1",
                        blocks({"B " + kLine})),
               "a.dxf");
  CHECK(listing(structure) ==
        "rejected:\n"
        "a.dxf:6 BLOCK #B: block that is never inserted\n"
        "a.dxf:30 INSERT (0): array of 1000000000 x 1000000000 copies, more than 1000000\n");
}

TEST_CASE("blocks within blocks are stored once and placed by the product of their maps") {
  const auto structure = read_dxf(
      dxf_with(
          "0 INSERT 2 OUTER 8 W 10 100 20 0 0 INSERT 2 OUTER 8 W 10 0 20 100 50 180",
          blocks(
              {"OUTER 10 0 20 0 0 INSERT 2 INNER 8 0 10 1 20 0 0 INSERT 2 INNER 8 D 10 2 20 0",
               "INNER 10 0 20 0 0 LINE 8 0 10 0 20 0 11 0 21 1 0 LINE 8 E 10 0 20 0 11 0 21 2"})),
      "a.dxf");
  CHECK(listing(structure) ==
        "101 0, 101 1 | a.dxf:44 LINE (W/OUTER/INNER)\n"
        "101 0, 101 2 | a.dxf:56 LINE (W/OUTER/INNER/E)\n"
        "102 0, 102 1 | a.dxf:44 LINE (W/OUTER/D/INNER)\n"
        "102 0, 102 2 | a.dxf:56 LINE (W/OUTER/D/INNER/E)\n"
        "-1 100, -1 99 | a.dxf:44 LINE (W/OUTER/INNER)\n"
        "-1 100, -1 98 | a.dxf:56 LINE (W/OUTER/INNER/E)\n"
        "-2 100, -2 99 | a.dxf:44 LINE (W/OUTER/D/INNER)\n"
        "-2 100, -2 98 | a.dxf:56 LINE (W/OUTER/D/INNER/E)\n");
  const auto named = [&structure](const std::string& name) {
    return std::count_if(structure.structs.begin(), structure.structs.end(),
                         [&name](const plumbline::Struct& s) { return s.name == name; });
  };
  CHECK(named("OUTER") == 1);
  CHECK(named("INNER") == 1);
}

TEST_CASE("an oblique INSERT is turned by a rational rotation, which the ledger says") {
  const auto structure = read_dxf(
      dxf_with("0 INSERT 2 B 8 L 10 0 20 0 50 30", blocks({"B 0 LINE 8 0 10 0 20 0 11 5 21 0"})),
      "a.dxf");
  const plumbline::SegmentSet set = evaluate(structure);
  REQUIRE(set.segments.size() == 1);
  const plumbline::Point end = set.segments[0].b;
  CHECK(squared_distance({0, 0}, end) == 25);  // still an isometry
  CHECK(plumbline::nearest_double(end.y) == Approx(2.5).margin(1e-14));
  REQUIRE(set.ledger.size() == 1);
  CHECK(set.ledger[0].what == "rotation by 30 degrees");
  CHECK(set.ledger[0].bound == "1e-15 rad");
  CHECK(set.ledger[0].source.element == "INSERT");
}

TEST_CASE("a block within itself is an error that names the path and the line") {
  CHECK(error_of(dxf_with("0 INSERT 2 A 10 0 20 0",
                          blocks({"A 0 INSERT 2 B 10 0 20 0", "B 0 INSERT 2 C 10 0 20 0",
                                  "C 0 INSERT 2 B 10 0 20 0"}))) ==
        "a.dxf:38: a block is inserted in itself: \"B/C/B\"");
  // One that no insert reaches is never drawn.
  CHECK(error_of(dxf_with(kLine, blocks({"A 0 INSERT 2 A 10 0 20 0"}))) == "accepted");
}

TEST_CASE("missing, external, repeated and unused blocks are listed") {
  const auto structure = read_dxf(
      dxf_with("0 INSERT 2 Nowhere 10 0 20 0 0 INSERT 2 X 10 0 20 0 0 INSERT 2 B 10 0 20 0",
               blocks({"X 70 4 1 house.dwg", "B " + kLine, "b 0 TEXT 1 again", "Spare " + kLine})),
      "a.dxf");
  CHECK(listing(structure) ==
        "1 2, 3 5 | a.dxf:20 LINE (0/B)\n"
        "rejected:\n"
        "a.dxf:6 BLOCK: external reference is not followed: house.dwg\n"
        "a.dxf:38 TEXT: in the second definition of a block\n"
        "a.dxf:44 BLOCK #Spare: block that is never inserted\n"
        "a.dxf:68 INSERT (0): no block of this name: Nowhere\n");
}

TEST_CASE("the model space may be a block, and that of the paper is left out") {
  const auto structure =
      read_dxf(dxf_with("0 LINE 8 0 10 0 20 0 11 1 21 1",
                        blocks({"*Model_Space " + kLine, "*Paper_Space0 " + kLine})),
               "a.dxf");
  CHECK(listing(structure) ==
        "1 2, 3 5 | a.dxf:10 LINE (0)\n"
        "0 0, 1 1 | a.dxf:48 LINE (0)\n"
        "rejected:\n"
        "a.dxf:28 LINE: in paper space\n");
}

TEST_CASE("what a block has on layer 0 is seen as the layer of its insert is") {
  const std::string tables =
      "0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 OFF 62 -7 0 LAYER 2 ICE 70 1 0 ENDTAB 0 "
      "ENDSEC ";
  const std::string definitions =
      blocks({"IN 0 LINE 8 0 10 0 20 0 11 1 21 0 0 LINE 8 X 10 0 20 1 11 1 21 1",
              "OUT 0 LINE 8 0 10 0 20 2 11 1 21 2 0 INSERT 2 IN 8 0 10 0 20 5"});
  const auto segments = [&](const std::string& inserts) {
    return segments_of(evaluate(read_dxf(dxf_with(inserts, tables + definitions), "a.dxf")));
  };
  CHECK(segments("0 INSERT 2 OUT 8 W 10 0 20 0") == "0 2, 1 2\n0 5, 1 5\n0 6, 1 6\n");
  CHECK(segments("0 INSERT 2 OUT 8 OFF 10 0 20 0") == "0 6, 1 6\n");
  CHECK(segments("0 INSERT 2 OUT 8 ICE 10 0 20 0").empty());
  // Both at once: the block is stored once, its layer 0 apart.
  CHECK(segments("0 INSERT 2 IN 8 OFF 10 0 20 0 0 INSERT 2 IN 8 W 10 0 20 10") ==
        "0 1, 1 1\n0 10, 1 10\n0 11, 1 11\n");
}

TEST_CASE("blocks that double at each level are refused by their size, not followed for ever") {
  std::vector<std::string> tower{"B0 " + kLine};
  for (int i = 1; i < 64; ++i) {
    const std::string below = "0 INSERT 2 B" + std::to_string(i - 1) + " 10 0 20 0";
    tower.push_back("B" + std::to_string(i) + " " + below + " " + below);
  }
  const auto structure = read_dxf(dxf_with("0 INSERT 2 B63 10 0 20 0", blocks(tower)), "a.dxf");
  CHECK_THROWS_AS(evaluate(structure, {10'000}), plumbline::Error);
}

TEST_CASE("a chain of 20,000 blocks is followed without recursion") {
  std::vector<std::string> chain{"B0 10 0 20 0 " + kLine};
  for (int i = 1; i < 20'000; ++i) {
    chain.push_back("B" + std::to_string(i) + " 10 0 20 0 0 INSERT 2 B" + std::to_string(i - 1) +
                    " 8 0 10 1 20 0");
  }
  CHECK(drawn("0 INSERT 2 B19999 8 0 10 0 20 0", chain) == "20000 2, 20002 5\n");
}

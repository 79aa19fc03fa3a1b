// Structures as JSON: what is read, what is refused, and the way there and back.

#include <catch2/catch.hpp>

#include "plumbline/error.hpp"
#include "plumbline/output.hpp"
#include "plumbline/read.hpp"
#include "support/listing.hpp"

using namespace plumbline;

namespace {

Structure read_text(const std::string& text) { return read_struct_json(text, "a.json"); }

std::string refusal(const std::string& text) {
  try {
    const Structure structure = read_text(text);
    dimension(structure);
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::BadInput);
    return error.what();
  }
  return "no error";
}

std::string with_body(const std::string& body) {
  return R"({"root": "S", "defs": {"M": {"V": [[0, 0], [1, 0]], "EV": [[0, 1]]}, "S": {"body": [)" +
         body + "]}}}";
}

}  // namespace

TEST_CASE("decimals and fractions are read exactly") {
  const auto set = evaluate(read_text(
      R"({"root": "M", "defs": {"M": {"V": [[0.1, 1e-3], ["1/3", "-0.2"]], "EV": [[0, 1]]}}})"));
  REQUIRE(set.segments.size() == 1);
  CHECK(to_text(set.segments[0]) == "0.1 0.001, 1/3 -0.2");
  CHECK(set.sources[0].element == "model");
  CHECK(set.sources[0].id == "M");
  CHECK(set.sources[0].line == 1);
}

TEST_CASE("references, maps, inline structures and lines are one body") {
  CHECK(listing(read_text(with_body(R"(
      {"op": "t", "args": [10, 0]}, {"ref": "M"},
      {"name": "inner", "body": [{"op": "s", "args": [2, 2]}, {"ref": "M"}]},
      {"mat": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}, {"ref": "M"},
      {"lines": [[[0, 0], [0, 5]]], "element": "wall", "id": "w", "line": 7})"))) ==
        "10 0, 11 0 | a.json:1:29 model #M (M)\n"
        "10 0, 12 0 | a.json:1:29 model #M (inner/M)\n"
        "10 0, 10 1 | a.json:1:29 model #M (M)\n"
        "10 0, 5 0 | a.json:7 wall #w\n");
}

TEST_CASE("quarter turns in radians and in degrees are exact, others are in the ledger") {
  const Structure exact = read_text(with_body(
      R"({"op": "r", "degrees": 90}, {"ref": "M"}, {"op": "r", "args": [1.5707963267948966]}, {"ref": "M"})"));
  const auto set = evaluate(exact);
  CHECK(to_text(set.segments[0]) == "0 0, 0 1");
  CHECK(to_text(set.segments[1]) == "0 0, -1 0");
  REQUIRE(set.ledger.size() == 1);  // the decimal is not a quarter turn
  CHECK(set.ledger[0].what == "r(1.5707963267948966)");
  CHECK(set.ledger[0].bound == "1e-15 rad");
  const auto turned = evaluate(read_text(with_body(R"({"op": "r", "degrees": 30}, {"ref": "M"})")));
  REQUIRE(turned.ledger.size() == 1);
  CHECK(turned.ledger[0].what == "rotation by 30 degrees");
  const auto [a, b] = turned.segments[0];
  CHECK(b.x * b.x + b.y * b.y == 1);
}

TEST_CASE("a map applies to all that follows it, as recorded by the traversal of nested lists") {
  // Numbers are models, letters are maps: [1, A, [2, 3, B, 4, C, 5, 6, D], E, 7, 8, 9]. The printed
  // code never pops its stack and gives 7 the maps E C B A (L11); the document's text gives E A.
  const auto structure = read_text(R"({"root": "S", "defs": {
      "M": {"V": [[0, 0], [1, 0]], "EV": [[0, 1]]},
      "S": {"body": [{"ref": "M"}, {"op": "t", "args": [1, 0]},
        {"body": [{"ref": "M"}, {"op": "t", "args": [10, 0]}, {"ref": "M"},
                  {"op": "t", "args": [100, 0]}, {"ref": "M"}, {"op": "t", "args": [1000, 0]}]},
        {"op": "t", "args": [10000, 0]}, {"ref": "M"}]}}})");
  std::string begins;
  const auto set = evaluate(structure);
  for (const auto& segment : set.segments) begins += exact_text(segment.a.x) + " ";
  CHECK(begins == "0 1 11 111 10001 ");
}

TEST_CASE("malformed structures are refused with their place") {
  const auto [text, what] = GENERATE(table<std::string, std::string>({
      {"[]", "a.json:1:1: not an object"},
      {"{}", "a.json:1:1: no member \"defs\""},
      {R"({"defs": {}})", "a.json:1:1: no member \"root\""},
      {R"({"defs": {}, "root": "S"})", "no definition has this name: \"S\""},
      {R"({"defs": {}, "root": 3})", "not the name of a definition: \"3\""},
      {R"({"defs": {}, "defs": {}})", "a member that is there twice: \"defs\""},
      {R"({"defs": {"S": {"body": [], "colour": 1}}, "root": "S"})",
       "a member that is not understood here: \"colour\""},
      {with_body(R"({"ref": "X"})"), "no definition has this name: \"X\""},
      {with_body(R"({"ref": "S"})"), "a.json: cycle of references: \"S/S\""},
      {with_body(R"({"op": "q", "args": [1]})"), "not one of the operations t, s and r: \"q\""},
      {with_body(R"({"op": "r", "args": [1, 2]})"), "a rotation has one number or three"},
      {with_body(R"({"op": "t"})"), "an operation needs \"args\""},
      {with_body(R"({"op": "t", "args": [1, "x"]})"), "not a number: \"x\""},
      {with_body(R"({"op": "t", "args": [1, 2, 3]}, {"ref": "M"})"),
       "mixed dimensions: a model of dimension 2 (item 1 of M) and a map of dimension 3 (item 1 of "
       "S)"},
      {with_body(R"({"mat": [[1, 0], [0]]})"), "a matrix that is not square"},
      {with_body(R"({"mat": [[1, 0], [1, 1]]})"), "the last row of a matrix is not 0 ... 0 1"},
      {with_body(R"({"V": [[0, 0]]})"), "a model without cells"},
      {with_body(R"({"V": [[0, 0], [1]], "EV": []})"), "points of different dimensions"},
      {with_body(R"({"V": [[0, 0]], "EV": [[0, 1]]})"), "a cell with vertex 1 of a model with 1"},
      {with_body(R"({"V": [[0, 0]], "EV": [[0, -1]]})"), "not a whole number from 0 to 2^32 - 1"},
      {with_body(R"({"lines": [[[0, 0], [1, 1, 1]]]})"), "not two points of the plane"},
      {with_body(R"({"lines": [[[0, 0], [1, 1], [2, 2]]]})"), "not two points of the plane"},
      {with_body(R"({"shape": []})"), "a grid of dimension 0"},
      {with_body(R"({"lines": [[[0, 0], [1, 1]]], "rows": [[1, 2, 2]]})"), "not as many segments"},
      {with_body(R"({"lines": [[[0, 0], [1, 1]]], "rings": [[0, 1, "disc"]]})"),
       "not polygon, part"},
      {with_body(R"({"lines": [[[0, 0], [1, 1]]], "rings": [[0, 2, "line"]]})"),
       "not the lines of a"},
      {with_body(R"({"lines": [], "labels": [{"text": "a", "place": [1]}]})"), "not a point of"},
      {with_body(R"({"lines": [], "labels": [{"text": "a", "row": 1}]})"), "not of a row"},
      {with_body(R"({"lines": [], "labels": [{}]})"), "no member \"text\""},
      {with_body("7"), "not an object: \"7\""},
      {R"({"root": "S", "defs": )", "not JSON"},
  }));
  CAPTURE(text);
  CHECK_THAT(refusal(text), Catch::Contains(what));
}

TEST_CASE("a hundred thousand nested structures are read, written and read again") {
  constexpr int kDepth = 100'000;
  std::string text;
  for (int i = 0; i < kDepth; ++i) text += R"({"body": [{"op": "t", "args": [1, 0]}, )";
  text += R"({"ref": "M"})";
  for (int i = 0; i < kDepth; ++i) text += "]}";
  const Structure structure = read_text(with_body(text));
  CHECK(to_text(evaluate(structure).segments[0]) == "100000 0, 100001 0");
  CHECK(evaluate(read_text(to_json(structure))).segments == evaluate(structure).segments);
}

TEST_CASE("a structure that is written is read back, equal") {
  Structure structure = read_svg(
      R"svg(<svg><g id="flat" transform="translate(0.5,-3)"><line id="w" x1="0" y1="0" x2="1" y2="0.1"/>
         <g id="flat"><rect width="2" height="3" transform="rotate(30)"/></g></g><text>x</text></svg>)svg",
      "b.svg");
  Structure table = read_lines("0,0,1,1\n\n2,2,3,3\n", "c.lines");
  structure.structs[structure.root].body.push_back(
      table.structs[table.root].body.front());  // rows of their own
  Structure features = read_wkt("LINESTRING (0 0, 1 1, 2 0)\nLINESTRING (5 5, 6 6)\n", "d.wkt");
  auto lines = std::get<Model>(features.structs[features.root].body.front());
  REQUIRE(lines.rows.at(0).segment_count == 2);
  lines.row_ids = {"first"};
  lines.rows[0].id = 1;
  lines.source.layer = "walls";
  lines.labels = {{"A", plumbline::NumberPoint{Rational(1, 3), Rational(1, 2)}, 0}, {"B", {}, 1}};
  structure.unit = plumbline::LengthUnit{"US survey ft", Rational(1200, 3937)};
  structure.layers = {{"walls", 0xff0000, true}, {"0", {}, false}};
  structure.structs[structure.root].body.emplace_back(lines);
  structure.structs.push_back(
      {"", "grid", {cuboids({2, 1}, true), Affine{0, 1, 1, 0, Rational(1, 3), 0}}});
  structure.rejected = {{{0, 2, 3, "text", "", ""}, "not understood", "t", true},
                        {{0, 4, 5, "MLINE", "", ""}, "not understood", "", false}};
  structure.remarks = {{{0, 6, 7, "Polygon", "7", ""}, "ring is not closed", "1 ring"}};
  Structure again = read_text(to_json(structure));
  REQUIRE(again.files == std::vector<std::string>{"b.svg", "a.json"});
  again.files.pop_back();
  CHECK(again == structure);
  CHECK(to_json(again) == to_json(structure));
}

TEST_CASE("what is far too large is refused before it is made") {
  const std::string text = GENERATE(
      as<std::string>{}, R"({"shape": [268435455]})",
      R"({"shape": [1,1,1,1,1,1,1,1,1,1,1,1,1,1,1], "skeletons": true})",
      R"({"shape": [3000, 3000]}, {"shape": [2999, 2999]}, {"shape": [2998, 2998]})",
      R"({"mat": [)" + std::string(200, ' ') + "[1]" +
          [] {
            std::string rows;
            for (int i = 0; i < 1000; ++i) rows += ", [1]";
            return rows;
          }() +
          "]}",
      R"({"op": "t", "args": [0)" +
          [] {
            std::string zeros;
            for (int i = 0; i < 1000; ++i) zeros += ", 0";
            return zeros;
          }() +
          "]}");
  try {
    read_text(with_body(text));
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.place().line == 1);
  }
  CHECK(std::get<LarModel>(
            read_text(
                with_body(
                    R"({"shape": [0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0], "skeletons": true})"))
                .structs[1]
                .body.front())
            .vertex_count() == 1);
}

TEST_CASE("a model is written by the names of its arrays") {
  const auto arrays = [](std::size_t count) {
    LarModel model = cuboids({1, 1, 1}, true);
    model.cells.resize(count);
    std::string names;
    for (const char* name : {"CV", "FV", "EV", "cells"}) {
      if (to_json(model).find('"' + std::string(name) + '"') != std::string::npos) {
        names += std::string(name) + " ";
      }
    }
    return names;
  };
  CHECK(arrays(1) == "CV ");
  CHECK(arrays(2) == "FV EV ");
  CHECK(arrays(3) == "CV FV EV ");
  CHECK(arrays(4) == "cells ");
}

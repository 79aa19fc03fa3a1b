// Rotations are added along the way before their sum is replaced.

#include <algorithm>
#include <catch2/catch.hpp>

#include "plumbline/plumbline.hpp"
#include "support/dxf_text.hpp"
#include "support/listing.hpp"

using namespace plumbline;

namespace {

Turn turn(int degrees) { return {degrees}; }

/// The segment from (1, 2) to (3, 5).
Model line() { return {{}, {{{1, 2}, {3, 5}}}}; }

Structure structure_of(std::vector<Struct> structs) {
  Structure structure;
  structure.structs = std::move(structs);
  structure.root = StructId(0);
  return structure;
}

/// Where the maps, in one body, take the line.
std::string image(std::vector<Struct::Item> maps) {
  maps.emplace_back(line());
  return segments_of(evaluate(structure_of({{"", "", std::move(maps)}})));
}

/// The same drawing under nested groups with these transforms.
Structure svg_under(const std::vector<std::string>& transforms) {
  std::string open, close;
  for (const std::string& transform : transforms) {
    open += "<g transform='" + transform + "'>";
    close += "</g>";
  }
  return read_svg("<svg>" + open +
                      "<rect width='10' height='7'/><path d='M-1 -2 L8 9 L3 -4 Z'/>"
                      "<rect x='3' y='1' width='2' height='2' transform='rotate(10)'/>" +
                      close + "</svg>",
                  "a.svg");
}

std::string signature_of(const Structure& structure) {
  return signature(arrange(evaluate(structure)));
}

std::string ledger_of(const SegmentSet& set) {
  std::string text;
  for (const Replacement& entry : set.ledger) {
    text += to_text(entry.source, set.files) + ": " + entry.what + " by " + entry.bound + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("rotations that add up to quarter turns are exact") {
  const std::string turned = "-2 1, -5 3\n";  // by 90 degrees
  CHECK(image({turn(45), turn(45)}) == turned);
  CHECK(image({turn(30), turn(30), turn(30)}) == turned);
  CHECK(image({turn(100), turn(-10)}) == turned);
  CHECK(image({turn(350), turn(100)}) == turned);
  CHECK(image({turn(-45), turn(45)}) == "1 2, 3 5\n");
  CHECK(image({turn(90)}) == turned);
  CHECK(image({{Turn{Rational(1, 7)}}, Turn{Rational(629, 7)}}) == turned);
}

TEST_CASE("scalings by one factor and reflections are passed, a reflection turns the angle round") {
  CHECK(image({turn(45), scaling(2, 2), turn(45)}) == "-4 2, -10 6\n");
  CHECK(image({turn(45), scaling(-1, 1), turn(45)}) == "-1 2, -3 5\n");
  CHECK(image({turn(45), Affine(0, 3, 3, 0, 0, 0), turn(-45), turn(90)}) == "6 3, 15 9\n");
  CHECK(image({turn(45), Affine(3, 4, -4, 3, 0, 0), turn(45)}) ==
        image({turn(90), Affine(3, 4, -4, 3, 0, 0)}));
}

TEST_CASE("what is moved between rotations is turned by the sum of those above it") {
  const auto moved = [](int sum, const std::string& by) {
    Structure place = structure_of({{"", "", {turn(sum), Model{{}, {{{0, 0}, {10, 0}}}}}}});
    const Point shift = evaluate(place).segments[0].b;
    return image({translation(shift.x, shift.y), turn(sum + std::stoi(by))});
  };
  CHECK(image({turn(45), translation(10, 0), turn(45)}) == moved(45, "45"));
  CHECK(image({turn(20), turn(25), translation(10, 0), turn(45)}) == moved(45, "45"));
  CHECK(image({turn(45), translation(10, 0), turn(-45)}) == moved(45, "-45"));
  // There and back again.
  CHECK(image({turn(45), translation(10, 3), turn(10), translation(1, 1), translation(-1, -1),
               turn(-10), translation(-10, -3), turn(-45)}) == "1 2, 3 5\n");
}

TEST_CASE("other maps between rotations end a sum") {
  const auto replaced = [](const std::vector<Affine>& maps) {
    Affine product;
    for (const Affine& map : maps) product = compose(product, map);
    return image({product});
  };
  const Affine r45 = rotation(45).map;
  CHECK(image({turn(45), scaling(2, 1), turn(45)}) == replaced({r45, scaling(2, 1), r45}));
  // Within each sum angles are added, and quarter turns go on.
  CHECK(image({turn(45), turn(45), scaling(2, 1), turn(30), turn(60)}) ==
        replaced({rotation(90).map, scaling(2, 1), rotation(90).map}));
  CHECK(image({turn(45), scaling(2, 1), turn(90), scaling(2, 1), turn(-45)}) ==
        image({turn(90), scaling(2, 2)}));
  CHECK(image({turn(45), translation(1, 2), scaling(2, 1), turn(20), translation(3, 0)}) ==
        replaced({r45, translation(1, 2), scaling(2, 1), rotation(20).map, translation(3, 0)}));
}

TEST_CASE("the ledger lists the sums that were replaced") {
  const auto ledger = [](const std::vector<std::string>& transforms) {
    std::string text;
    for (const std::string& transform : transforms) text += "<g transform='" + transform + "'>";
    text += "<line x2='1'/>";
    for (std::size_t i = 0; i < transforms.size(); ++i) text += "</g>";
    return ledger_of(evaluate(read_svg("<svg>" + text + "</svg>", "a.svg")));
  };
  CHECK(ledger({"rotate(45)", "rotate(45)"}).empty());
  CHECK(ledger({"rotate(20)", "rotate(30)"}) ==
        "a.svg:1:32 g: rotation by 50 degrees by 1e-15 rad\n");
  CHECK(ledger({"rotate(20) translate(1)", "rotate(-20)"}) ==
        "a.svg:1:45 g: rotation by 20 degrees by 1e-15 rad\n");
  CHECK(ledger({"rotate(20) scale(1 2)", "rotate(70)"}) ==
        "a.svg:1:43 g: rotation by 20 degrees by 1e-15 rad\n"
        "a.svg:1:43 g: rotation by 70 degrees by 1e-15 rad\n");
  const Structure twice = structure_of({{"", "", {StructId(1), StructId(2), StructId(1)}},
                                        {"", "", {turn(30), line()}},
                                        {"", "", {turn(30), line(), turn(60), line()}}});
  CHECK(ledger_of(evaluate(twice)) == ": rotation by 30 degrees (2 of them) by 1e-15 rad\n");
  CHECK(replaced_rotations(twice) == evaluate(twice).ledger);
}

TEST_CASE("a drawing within rotations has the complex of the drawing within their sum") {
  const std::string quarter = signature_of(svg_under({"rotate(90)"}));
  CHECK(signature_of(svg_under({"rotate(45)", "rotate(45)"})) == quarter);
  CHECK(signature_of(svg_under({"rotate(45) rotate(45)"})) == quarter);
  CHECK(signature_of(svg_under({"rotate(30)", "rotate(30)", "rotate(30)"})) == quarter);
  CHECK(signature_of(svg_under({"scale(1 -1)", "rotate(-30)", "scale(1 -1)", "rotate(60)"})) ==
        quarter);
  CHECK(signature_of(svg_under({"rotate(17.5 3 4)", "rotate(-17.5 3 4)"})) ==
        signature_of(svg_under({})));
  CHECK(signature_of(svg_under({"rotate(20 3 4)", "rotate(25 3 4)", "rotate(45 3 4)"})) ==
        signature_of(svg_under({"rotate(90 3 4)"})));
}

TEST_CASE("a square turned twice by 45 degrees is the square beside it") {
  const ExactComplex complex = arrange(evaluate(read_svg(
      "<svg><g transform='rotate(45)'><g transform='rotate(45)'><rect width='10' height='10'/></g>"
      "</g><rect x='-10' width='10' height='10'/></svg>",
      "a.svg")));
  CHECK(complex.vertices.size() == 4);
  CHECK(complex.edge_count() == 4);
  CHECK(complex.face_count() == 2);
}

TEST_CASE("blocks turned within turned blocks are exact where the angles add up") {
  const auto drawn = [](const std::string& outer, const std::string& inner) {
    const std::string blocks =
        "0 SECTION 2 BLOCKS 0 BLOCK 2 A 0 LINE 8 0 10 1 20 2 11 3 21 5 0 "
        "ENDBLK 0 BLOCK 2 B 0 INSERT 2 A 20 0 " +
        inner + " 0 ENDBLK 0 ENDSEC";
    return segments_of(evaluate(read_dxf(dxf_with("0 INSERT 2 B 20 0 " + outer, blocks), "a.dxf")));
  };
  CHECK(drawn("10 0 50 45", "10 0 50 45") == "-2 1, -5 3\n");
  CHECK(drawn("10 7 50 45 41 2 42 2", "10 0 50 45") == "3 2, -3 6\n");
  CHECK(drawn("10 0 50 30 41 -1", "10 0 50 30") == "-1 2, -3 5\n");
  CHECK(drawn("10 0 50 30 210 0 220 0 230 -1", "10 0 50 -30") == "-1 2, -3 5\n");
  CHECK(drawn("10 0 50 45", "10 0 50 45 70 2 44 10") == "-2 1, -5 3\n-2 11, -5 13\n");
}

TEST_CASE("Structs turned within turned Structs are exact, and written as they are") {
  const std::string text = R"({"root": "S", "defs": {
      "M": {"V": [[1, 2], [3, 5]], "EV": [[0, 1]]},
      "T": {"body": [{"op": "r", "degrees": 45}, {"ref": "M"}]},
      "S": {"body": [{"op": "r", "degrees": "45"}, {"ref": "T"}]}}})";
  const Structure structure = read_struct_json(text, "a.json");
  CHECK(segments_of(evaluate(structure)) == "-2 1, -5 3\n");
  CHECK(evaluate(structure).ledger.empty());
  const Structure again = read_struct_json(to_json(structure), "b.json");
  CHECK(segments_of(evaluate(again)) == "-2 1, -5 3\n");
  CHECK(to_json(again).find(R"("line": 4)") != std::string::npos);
}

TEST_CASE("the box is that of what is drawn, whatever is turned") {
  const Structure structure = structure_of(
      {{"",
        "",
        {turn(20), translation(3, 1), StructId(1), scaling(1, 2), StructId(1), StructId(2)}},
       {"", "", {turn(25), line(), translation(5, 0), turn(45), line(), StructId(2)}},
       {"", "", {translation(-2, 0), turn(-70), line()}}});
  const SegmentSet set = evaluate(structure);
  Point low = set.segments[0].a, high = low;
  for (const Segment& s : set.segments) {
    for (const Point& p : {s.a, s.b}) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const auto found = box(structure);
  REQUIRE(found);
  CHECK(found->low == std::vector<Number>{low.x, low.y});
  CHECK(found->high == std::vector<Number>{high.x, high.y});
}

TEST_CASE("who parses doubles has one matrix for what stands together") {
  const Structure turned = structure_of({{"",
                                          "",
                                          {translation(3, 4), turn(30), translation(-3, -4), line(),
                                           scaling(Rational(1, 3), 1), line()}}});
  const Affine about = compose(translation(3, 4), compose(rotation(30).map, translation(-3, -4)));
  const Structure flat =
      structure_of({{"", "", {about, line(), scaling(Rational(1, 3), 1), line()}}});
  CHECK(rounded(turned) == rounded(flat));
  CHECK(evaluate_rounded(turned).segments == evaluate_rounded(flat).segments);
}

TEST_CASE("a rotation of the plane is embedded, and no map of space") {
  const Structure plan = structure_of({{"", "", {turn(30), line()}}});
  CHECK(dimension(embed(plan, 1)) == 3);
  CHECK(embed(plan, 1).ledger == evaluate(plan).ledger);
  CHECK_THROWS_AS(dimension(structure_of({{"", "", {turn(30), cuboids({1, 1, 1})}}})), Error);
}

TEST_CASE("a thousand rotations one within another are no more than their sum") {
  std::vector<Struct::Item> maps;
  for (int i = 0; i < 1000; ++i) {
    maps.emplace_back(turn(9));
    maps.emplace_back(translation(1, 0));
  }
  const std::string once = image(maps);
  CHECK(once == "1 2, 3 5\n");
}

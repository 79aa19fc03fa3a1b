#include <catch2/catch.hpp>

#include "plumbline/arrange.hpp"
#include "plumbline/features.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"
#include "plumbline/read.hpp"

using namespace plumbline;

namespace {

std::size_t occurrences(const std::string& text, const std::string& of) {
  std::size_t count = 0;
  for (auto at = text.find(of); at != text.npos; at = text.find(of, at + 1)) ++count;
  return count;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

/// Two rooms of 12 and 18 m2 in millimetres, one of which has a hostile name.
struct Flat {
  SegmentSet input;
  ExactComplex complex;
  Rooms found;
};

const std::string kEvil = "</script><img src=x onerror=alert(1)>\"&\x1b[31m";

Flat flat() {
  Flat result;
  result.input = evaluate(read_svg(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="7000mm" height="3000mm" viewBox="0 0 7000 3000">
           <rect width="4000" height="3000"><title>Bath</title></rect>
           <rect x="4000" width="3000" height="3000"/></svg>)",
      "flat.svg"));
  result.input.labels.push_back({SourceId(0), kEvil, Point{5000, 1000}});
  result.complex = arrange(result.input);
  result.found = rooms(result.input, result.complex);
  return result;
}

}  // namespace

TEST_CASE("rooms as a table: numbers, areas in square metres, names, neighbours") {
  const auto [input, complex, found] = flat();
  const std::string text = to_text(found, input);
  CHECK(holds(text, "2 rooms, 2 with a name, 21.00 m2 in all\n"));
  CHECK(holds(text, "    1      12.00 m2  Bath"));
  CHECK(holds(text, "    2       9.00 m2  "));
  CHECK_FALSE(holds(text, "\x1b"));
  CHECK(holds(to_text(found, input, 1), "... and 1 smaller ("));
}

TEST_CASE("rooms as JSON: exact areas beside rounded ones") {
  const auto [input, complex, found] = flat();
  const std::string json = to_json(found, input);
  CHECK(holds(json, R"("area": 1.2e+07,)"));
  CHECK(holds(json, R"("area_exact": "12000000",)"));
  CHECK(holds(json, R"("area_m2": 12,)"));
  CHECK(holds(json, R"("metres": "0.001")"));
  CHECK(holds(json, R"("shared": 3000,)"));
}

TEST_CASE("rooms as a plan and as a page: a shape each, names are text") {
  const auto [input, complex, found] = flat();
  for (const std::string& picture :
       {to_svg(found, input, complex), to_html(found, input, complex)}) {
    CHECK(occurrences(picture, "<path data-room=") == 2);
    CHECK(holds(picture, ">Bath<"));
    CHECK(holds(picture, "12.00 m2"));
    CHECK_FALSE(holds(picture, "<img"));
    CHECK(holds(picture, ">1 m<"));  // the scale bar
  }
  CHECK(occurrences(to_html(found, input, complex), "<tr data-room=") == 2);
}

TEST_CASE("rooms as features: polygons of the rounded complex with the exact areas") {
  const auto [input, complex, found] = flat();
  const FeatureLayer layer = room_layer(found, safely_rounded(complex, {}));
  REQUIRE(layer.features.size() == 2);
  CHECK(layer.columns[1] == "name");
  CHECK(layer.columns[4] == "area_m2");
  CHECK(layer.features[0].values[1] == FeatureValue("Bath"));
  CHECK(layer.features[0].values[3] == FeatureValue("12000000"));
  CHECK(layer.features[0].values[4] == FeatureValue(12.0));
  CHECK(layer.features[0].parts[0].size() == 4);
}

TEST_CASE("the example plan has three rooms once its furniture is left out") {
  DrawingOptions options;
  options.walls = {"walls", "DOORS"};
  const Drawing drawing = exact_answer(PLUMBLINE_EXAMPLES "/flat.dxf", options);
  const Rooms found = rooms(drawing.input, drawing.complex);
  REQUIRE(found.rooms.size() == 3);
  CHECK(found.rooms[0].names == std::vector<std::string>{"Kitchen"});
  CHECK(found.rooms[1].names == std::vector<std::string>{"Bedroom"});
  CHECK(found.rooms[2].names == std::vector<std::string>{"Living room"});
  for (const Room& room : found.rooms) {
    CHECK(room.layers == std::vector<std::string>{"DOORS", "WALLS"});
    for (const RoomNeighbour& next : room.neighbours) CHECK(next.door);
  }
  // The plan is 10 x 8 m with a bay, its rooms fill it.
  Rational sum;
  for (const Room& room : found.rooms) sum += room.area;
  CHECK(nearest_double(sum) > 80);
  CHECK(nearest_double(sum) < 82);
}

TEST_CASE("one room is no rooms") {
  SegmentSet input = evaluate(read_lines("0,0,4,0\n4,0,4,4\n4,4,0,0\n", "one.lines"));
  const ExactComplex complex = arrange(input);
  const Rooms found = rooms(input, complex);
  CHECK(holds(to_text(found, input), "1 room, "));
  CHECK(holds(to_svg(found, input, complex), ">one.lines: 1 room, 8<"));
  CHECK(holds(to_html(found, input, complex), "<p>1 room, 8</p>"));
}

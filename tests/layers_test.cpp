// Which layers of a drawing are read, and what is said of the others.

#include <catch2/catch.hpp>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "read/layer_choice.hpp"
#include "support/dxf_text.hpp"
#include "support/listing.hpp"

namespace {

using plumbline::dxf_with;
using plumbline::ReadOptions;
using Globs = std::vector<std::string>;

ReadOptions with(Globs layers, Globs without = {}) {
  ReadOptions options;
  options.layers = std::move(layers);
  options.without_layers = std::move(without);
  return options;
}

template <class Read>
std::string error_of(const Read& read) {
  try {
    read();
  } catch (const plumbline::Error& error) {
    return error.what();
  }
  return "no error";
}

const std::string kDxf = dxf_with(
    "0 LINE 8 A-WALL 10 0 20 0 11 1 21 0 0 LINE 8 A-DOOR 10 0 20 1 11 1 21 1 "
    "0 TEXT 8 A-DOOR 10 0 20 0 1 Door 0 LINE 8 0 10 0 20 2 11 1 21 2 "
    "0 INSERT 2 B 8 A-DOOR 10 0 20 10 0 INSERT 2 B 8 A-WALL 10 0 20 20",
    "0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 0 20 0 0 LINE 8 0 10 0 20 0 11 1 21 0 "
    "0 LINE 8 A-WALL 10 0 20 1 11 1 21 1 0 ENDBLK 0 ENDSEC");

std::string of_dxf(const ReadOptions& options) {
  return segments_of(evaluate(plumbline::read_dxf(kDxf, "a.dxf", options)));
}

const std::string kSvg =
    "<svg xmlns='http://www.w3.org/2000/svg' "
    "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape'>\n"
    "<g id='g1' inkscape:label='Walls'><line x2='1'/><g id='fine'><line x2='2'/></g></g>\n"
    "<g id='g2'><line id='only' x2='3'/><use href='#fine'/></g><text>Word</text></svg>";

std::string of_svg(const ReadOptions& options) {
  return segments_of(evaluate(plumbline::read_svg(kSvg, "a.svg", options)));
}

}  // namespace

TEST_CASE("a star stands for any characters, a question mark for one, letters for either case") {
  using plumbline::matches_pattern;
  CHECK(matches_pattern("A-WALL-EXT", "a-wall*"));
  CHECK(matches_pattern("A-WALL-EXT", "*EXT"));
  CHECK(matches_pattern("A-WALL-EXT", "*-*-*"));
  CHECK(matches_pattern("abcabd", "*abd"));
  CHECK(matches_pattern("W\u00e4nde", "w?nde"));
  CHECK(matches_pattern("", "*"));
  CHECK(matches_pattern("a", "a**"));
  CHECK(!matches_pattern("A-WALL", "WALL"));
  CHECK(!matches_pattern("ab", "a"));
  CHECK(!matches_pattern("a", "a?"));
  CHECK(!matches_pattern("", "?"));
}

TEST_CASE("of a DXF the layers that are asked for are read, layer 0 of a block by its insert") {
  const std::string walls = "0 0, 1 0\n0 20, 1 20\n0 21, 1 21\n0 11, 1 11\n";
  CHECK(of_dxf(with({"A-WALL"})) == walls);
  CHECK(of_dxf(with({"*"}, {"0", "*door"})) == walls);
  CHECK(of_dxf(with({"a-door"})) == "0 1, 1 1\n0 10, 1 10\n");
  CHECK(of_dxf(with({"?"})) == "0 2, 1 2\n");
}

TEST_CASE("what is left out is counted, one harmless item for each layer") {
  const auto set = evaluate(plumbline::read_dxf(kDxf, "a.dxf", with({}, {"A-DOOR"})));
  CHECK(rejected_of(set) ==
        "a.dxf:58 LAYER (A-DOOR): what is on layer A-DOOR, which is left out as asked (2 of them)\n"
        "a.dxf:92 INSERT (A-DOOR): what the block has on layer 0, since layer A-DOOR is left out "
        "as asked\n");
  CHECK(lost_of(set).empty());
  CHECK(set.labels.empty());
}

TEST_CASE("of an SVG elements are read by their own label or id or those above them") {
  CHECK(of_svg(with({"walls"})) == "0 0, 1 0\n0 0, 2 0\n");
  CHECK(of_svg(with({"fine"})) == "0 0, 2 0\n0 0, 2 0\n");
  CHECK(of_svg(with({"g2"})) == "0 0, 3 0\n0 0, 2 0\n");
  CHECK(of_svg(with({"only"})) == "0 0, 3 0\n");
  CHECK(of_svg(with({}, {"fine"})) == "0 0, 1 0\n0 0, 3 0\n");
  CHECK(of_svg(with({"g*"}, {"Walls"})) == "0 0, 3 0\n0 0, 2 0\n");
  CHECK(rejected_of(evaluate(plumbline::read_svg(kSvg, "a.svg", with({"g2"}, {"only"})))) ==
        "a.svg:2:35 line (Walls): not on a layer that was asked for\n"
        "a.svg:2:62 line (Walls/fine): not on a layer that was asked for\n"
        "a.svg:3:12 line #only (g2): left out as asked\n"
        "a.svg:3:59 text: not on a layer that was asked for\n");
}

TEST_CASE("a pattern that nothing matches is an error that names the layers there are") {
  CHECK(error_of([] { of_dxf(with({"A-WALL"}, {"walls"})); }) ==
        "a.dxf: no layer of this name; there are \"0\", \"A-WALL\", \"A-DOOR\": \"walls\"");
  CHECK(error_of([] { of_svg(with({"doors"})); }) ==
        "a.svg: no layer of this name; there are \"Walls\", \"fine\", \"g2\": \"doors\"");
  CHECK(error_of([] {
          plumbline::read(PLUMBLINE_EXAMPLES "/rooms.csv", with({"*"}));
        }).ends_with("no layer of this name; there are none: \"*\""));
  CHECK(error_of([] {
          plumbline::read(PLUMBLINE_EXAMPLES "/rooms.lines", with({}, {"x"}));
        }).ends_with("no layer of this name; there are none: \"x\""));
}

TEST_CASE("clip-paths and masks are told of once") {
  const std::string svg =
      "<svg><g clip-path='url(#c)'><line x2='1' style='clip-path:url(#d)'/></g>"
      "<line x2='2' mask='url(#m)' clip-path='none'/></svg>";
  CHECK(remarks_of(evaluate(plumbline::read_svg(svg, "a.svg"))) ==
        "a.svg:1:6 g: clip-path is not applied: what it hides is drawn (2 of them): url(#c)\n"
        "a.svg:1:73 line: mask is not applied: what it hides is drawn: url(#m)\n");
}

TEST_CASE("features of a GeoJSON are on the layer that a property names, and labels by others") {
  const std::string text = R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"Layer": "walls", "title": "T", "NAME": "Hall"}, "geometry":
 {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}},
{"type": "Feature", "properties": {"layer": "doors", "name": 5, "room": "R"}, "geometry":
 {"type": "LineString", "coordinates": [[2, 0], [3, 0]]}},
{"type": "Feature", "properties": {"layer": "walls", "Text": "Bath"}, "geometry":
 {"type": "Point", "coordinates": [0.25, 0.5]}},
{"type": "Feature", "properties": {"level": "doors"}, "geometry":
 {"type": "Point", "coordinates": [1, 1]}},
{"type": "Feature", "properties": null, "id": "m", "geometry":
 {"type": "MultiPolygon", "coordinates": [[[[5, 0], [6, 0], [5, 1], [5, 0]]],
                                          [[[7, 0], [8, 0], [7, 1], [7, 0]]]]}}]})";
  const auto read = [&](const ReadOptions& options) {
    return evaluate(plumbline::read_geojson(text, "a", options));
  };
  const auto set = read({});
  CHECK(labels_of(set) == "Hall | a:2:1 Polygon #Hall\nBath at 0.25 0.5 | a:6:1 Point\n");
  std::string layers;
  for (std::size_t i = 0; i < set.sources.size(); ++i) {
    layers += set.sources[i].element + " #" + set.sources[i].id + " " + set.sources[i].layer + "\n";
  }
  CHECK(layers ==
        "MultiPolygon #m/1 \nMultiPolygon #m/2 \nPolygon #Hall walls\nLineString #5 doors\n"
        "Point # walls\n");
  CHECK(rejected_of(set) == "a:8:1 Point: isolated points are not drawn: 1 point\n");
  REQUIRE(set.rings.size() == 3);
  CHECK(set.rings[2].first == 6);

  CHECK(segments_of(read(with({"Doors"}))) == "2 0, 3 0\n");
  CHECK(rejected_of(read(with({"Doors"})))
            .find("left out as asked: what is on layer walls: 2 elements") != std::string::npos);
  CHECK(segments_of(read(with({}, {"walls", ""}))) == "2 0, 3 0\n");
  CHECK(error_of([&] { read(with({"roof"})); }) ==
        "a: no layer of this name; there are \"walls\", \"doors\", \"\": \"roof\"");
  ReadOptions level = with({"doors"});
  level.layer_property = "LEVEL";
  CHECK(read(level).segments.empty());
}

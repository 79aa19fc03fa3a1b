#include "plumbline/features.hpp"

#include <rapidjson/document.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "inputs/families.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/engine.hpp"
#include "plumbline/output.hpp"
#include "plumbline/read.hpp"
#include "plumbline/structure.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

struct Written {
  SegmentSet input;
  ExactComplex complex = arrange(input);
  Rounding rounding = safely_rounded(complex, {});

  Features features(std::vector<FeatureLayer> layers) const {
    return {std::move(layers), "", note_of(rounding)};
  }
  Features faces() const { return features({face_layer(complex, input, rounding)}); }
  Features edges() const { return features({edge_layer(input, rounding)}); }
};

const std::string kRooms = rectangle(0, 0, 8, 4) + "4 0 4 4  6 4 6 2  " + rectangle(1, 1, 2, 2);

/// What a reader of doubles makes of a file.
ExactComplex read_back(const std::string& name, const std::string& content) {
  const auto file = std::filesystem::temp_directory_path() / ("plumbline_features_test_" + name);
  std::ofstream(file, std::ios::binary) << content;
  const SegmentSet input = evaluate(read(file));
  CHECK(input.rejected.empty());
  std::filesystem::remove(file);
  return arrange(rounded(input), 1);
}

}  // namespace

TEST_CASE("GeoJSON has a valid polygon for each room, with area, neighbours and sources") {
  const Written rooms{segments(kRooms)};
  rapidjson::Document json;
  json.Parse(to_geojson(rooms.faces()).c_str());
  REQUIRE(!json.HasParseError());
  CHECK(std::string(json["type"].GetString()) == "FeatureCollection");
  CHECK(std::string(json["numbers"].GetString()).find("proven") != std::string::npos);
  REQUIRE(json["features"].Size() == 3);
  const auto& room = json["features"][0];
  CHECK(std::string(room["geometry"]["type"].GetString()) == "Polygon");
  CHECK(room["geometry"]["coordinates"].Size() == 2);
  const auto& outer = room["geometry"]["coordinates"][0];
  CHECK(outer.Size() == 5);
  CHECK(outer[0] == outer[4]);
  CHECK(room["properties"]["area"].GetDouble() == 15);
  CHECK(std::string(room["properties"]["area_exact"].GetString()) == "15");
  CHECK(room["properties"]["parent"].GetInt() == 0);
  CHECK(json["features"][1]["properties"]["parent"].GetInt() == 1);
  CHECK(std::string(room["properties"]["neighbours"].GetString()) == "2 3");
  CHECK(std::string(room["properties"]["sources"].GetString()).find("text:1:1") !=
        std::string::npos);
}

TEST_CASE("where snap rounding changes faces, each polygon has an area of its own") {
  // A sliver above the lower side, narrower than the grid, which falls into parts.
  const SegmentSet input = segments("0 0 8 0  8 0 8 4  8 4 0 4  0 4 0 0  0 0 4 0.1  4 0.1 8 0");
  const ExactComplex complex = arrange(input);
  const Rounding rounding = safely_rounded(complex, Grid{0});
  REQUIRE_FALSE(rounding.has_same_incidences());
  const FeatureLayer layer = face_layer(complex, input, rounding);
  const std::vector<Rational> areas = face_areas(rounding.complex);
  REQUIRE(layer.features.size() + 1 == areas.size());
  for (std::size_t i = 0; i < layer.features.size(); ++i) {
    CHECK(std::get<double>(layer.features[i].values[1]) == nearest_double(areas[i + 1]));
  }
}

TEST_CASE("of several layers each feature says which one it is of") {
  const Written rooms{segments(kRooms)};
  rapidjson::Document json;
  json.Parse(to_geojson(rooms.features({edge_layer(rooms.input, rooms.rounding),
                                        vertex_layer(rooms.rounding)}))
                 .c_str());
  REQUIRE(!json.HasParseError());
  const std::size_t edges = rooms.complex.edge_count();
  REQUIRE(json["features"].Size() == edges + rooms.complex.vertices.size());
  CHECK(std::string(json["features"][0]["properties"]["layer"].GetString()) == "edges");
  CHECK(std::string(json["features"][static_cast<rapidjson::SizeType>(edges)]["properties"]["layer"]
                        .GetString()) == "vertices");
}

TEST_CASE("text forms of a point, a line, a polygon with a hole") {
  const Features features{
      {{"p", FeatureGeometry::Point, {"n"}, {{{{{0.1, -2}}}, {std::int64_t{7}}}}},
       {"l", FeatureGeometry::Line, {}, {{{{{0, 0}, {1e-7, 2.5}}}, {}}}},
       {"a",
        FeatureGeometry::Polygon,
        {},
        {{{{{0, 0}, {4, 0}, {0, 4}}, {{1, 1}, {1, 2}, {2, 1}}}, {}}}}},
      "",
      ""};
  CHECK(to_wkt(features) ==
        "POINT (0.1 -2)\n"
        "LINESTRING (0 0, 1e-07 2.5)\n"
        "POLYGON ((0 0, 4 0, 0 4, 0 0), (1 1, 1 2, 2 1, 1 1))\n");
  CHECK(to_csv(features.layers[0]) == "n,wkt\n7,POINT (0.1 -2)\n");
  CHECK(to_wkb_hex({{features.layers[0]}, "", ""}) ==
        "01010000009A9999999999B93F00000000000000C0\n");
}

TEST_CASE("CSV quotes what has commas, quotes and ends of lines") {
  const FeatureLayer layer{
      "l", FeatureGeometry::Line, {"a,b"}, {{{{{0, 0}, {1, 1}}}, {std::string("say \"x\"\n")}}}};
  CHECK(to_csv(layer) == "\"a,b\",wkt\n\"say \"\"x\"\"\n\",\"LINESTRING (0 0, 1 1)\"\n");
}

TEST_CASE("edges that are written and read back are the rounded complex") {
  std::size_t cells = 0;
  for (const std::string& family : inputs::families()) {
    INFO(family);
    const Written written{inputs::of_family(family, 11)};
    if (written.complex.edge_count() == 0 || !written.rounding.valid_as_doubles) continue;
    ExactComplex plain = written.rounding.complex;
    const std::string expected = signature(plain);
    bool has_isolated = false;
    for (std::size_t f = 0; f < plain.face_count(); ++f) {
      has_isolated = has_isolated || !plain.face_isolated_vertices[f].empty();
    }
    if (has_isolated) continue;  // which edges do not tell
    CHECK(signature(read_back("e.wkt", to_wkt(written.edges()))) == expected);
    CHECK(signature(read_back("e.geojson", to_geojson(written.edges()))) == expected);
    CHECK(signature(read_back("e.csv", to_csv(written.edges().layers[0]))) == expected);
    CHECK(signature(read_back("e.wkb", to_wkb_hex(written.edges()))) == expected);
    cells += plain.edge_count();
  }
  CHECK(cells > 300);
}

TEST_CASE("polygons that are written and read back have the faces of the rounded complex") {
  for (const std::string& family : inputs::families()) {
    INFO(family);
    const Written written{inputs::of_family(family, 12)};
    if (written.rounding.complex.face_count() < 2) continue;
    const auto areas = [](const ExactComplex& complex) {
      std::vector<Rational> all = face_areas(complex);
      std::sort(all.begin(), all.end());
      return all;
    };
    // An enclosed face is there once more as what its neighbours leave open, which changes nothing.
    CHECK(areas(read_back("f.wkt", to_wkt(written.faces()))) == areas(written.rounding.complex));
  }
}

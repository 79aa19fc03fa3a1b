#include <catch2/catch.hpp>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "support/listing.hpp"

using plumbline::evaluate;
using plumbline::listing;
using plumbline::read_geojson;

namespace {

std::string listed(const std::string& text) { return listing(read_geojson(text, "a.geojson")); }

std::string error_of(const std::string& text) {
  try {
    read_geojson(text, "a");
  } catch (const plumbline::Error& error) {
    return error.what();
  }
  return "accepted";
}

std::string feature(const std::string& geometry, const std::string& members) {
  return R"({"type": "Feature", "geometry": )" + geometry + ", " + members + "}";
}

std::string line(const std::string& coordinates) {
  return R"({"type": "LineString", "coordinates": )" + coordinates + "}";
}

}  // namespace

TEST_CASE("RFC 7946, 1.5: each feature of the example is drawn or listed") {
  CHECK(listed(R"({
       "type": "FeatureCollection",
       "features": [{
           "type": "Feature",
           "geometry": {
               "type": "Point",
               "coordinates": [102.0, 0.5]
           },
           "properties": {
               "prop0": "value0"
           }
       }, {
           "type": "Feature",
           "geometry": {
               "type": "LineString",
               "coordinates": [
                   [102.0, 0.0],
                   [103.0, 1.0],
                   [104.0, 0.0],
                   [105.0, 1.0]
               ]
           },
           "properties": {
               "prop0": "value0",
               "prop1": 0.0
           }
       }, {
           "type": "Feature",
           "geometry": {
               "type": "Polygon",
               "coordinates": [
                   [
                       [100.0, 0.0],
                       [101.0, 0.0],
                       [101.0, 1.0],
                       [100.0, 1.0],
                       [100.0, 0.0]
                   ]
               ]
           },
           "properties": {
               "prop0": "value0",
               "prop1": {
                   "this": "that"
               }
           }
       }]
   })") ==
        "102 0, 103 1 | a.geojson:12:11 LineString\n"
        "103 1, 104 0 | a.geojson:12:11 LineString\n"
        "104 0, 105 1 | a.geojson:12:11 LineString\n"
        "100 0, 101 0 | a.geojson:27:11 Polygon\n"
        "101 0, 101 1 | a.geojson:27:11 Polygon\n"
        "101 1, 100 1 | a.geojson:27:11 Polygon\n"
        "100 1, 100 0 | a.geojson:27:11 Polygon\n"
        "rejected:\n"
        "a.geojson:3:21 Point: isolated points are not drawn: 1 point\n");
}

TEST_CASE("RFC 7946, appendix A: the examples of geometries have the segments of their lines") {
  const auto count = [](const std::string& text) {
    return evaluate(read_geojson(text, "a")).segments.size();
  };
  CHECK(count(line("[[100.0, 0.0], [101.0, 1.0]]")) == 1);
  const std::string ring = "[[100.0, 0.0], [101.0, 0.0], [101.0, 1.0], [100.0, 1.0], [100.0, 0.0]]";
  const std::string hole = "[[100.8, 0.8], [100.8, 0.2], [100.2, 0.2], [100.2, 0.8], [100.8, 0.8]]";
  CHECK(count(R"({"type": "Polygon", "coordinates": [)" + ring + "," + hole + "]}") == 8);
  CHECK(count(R"({"type": "MultiPoint", "coordinates": [[100.0, 0.0], [101.0, 1.0]]})") == 0);
  CHECK(count(R"({"type": "MultiLineString", "coordinates": [[[100.0, 0.0], [101.0, 1.0]],
                 [[102.0, 2.0], [103.0, 3.0]]]})") == 2);
  CHECK(count(R"({"type": "MultiPolygon", "coordinates": [
      [[[102.0, 2.0], [103.0, 2.0], [103.0, 3.0], [102.0, 3.0], [102.0, 2.0]]],
      [)" + ring +
              "," + hole + "]]}") == 12);
  CHECK(count(R"({"type": "GeometryCollection", "geometries": [
      {"type": "Point", "coordinates": [100.0, 0.0]},
      {"type": "LineString", "coordinates": [[101.0, 0.0], [102.0, 1.0]]}]})") == 1);
}

TEST_CASE("coordinates are the decimals of the text, of any length") {
  CHECK(listed(line("[[0.1, 9007199254740993], [1e-3, -2.50E2]]")) ==
        "0.1 9007199254740993, 0.001 -250 | a.geojson:1:1 LineString\n");
  CHECK(listed(line("[[0, 0], [0.1234567890123456789012345678901, 1e30]]")) ==
        "0 0, 0.1234567890123456789012345678901 1000000000000000000000000000000 | "
        "a.geojson:1:1 LineString\n");
}

TEST_CASE("a feature is named by its id, else a property, wherever that stands") {
  const std::string geometry = line("[[0, 0], [1, 1]]");
  const auto named = [&](const std::string& members) { return listed(feature(geometry, members)); };
  const std::string segment = "0 0, 1 1 | a.geojson:1:1 LineString";
  CHECK(named(R"("id": "wall 7")") == segment + " #wall 7\n");
  CHECK(named(R"("id": 12.50)") == segment + " #12.50\n");
  CHECK(named(R"("properties": {"Name": "north", "deep": {"id": 3}, "ID": 4})") ==
        segment + " #4\n");
  CHECK(named(R"("properties": {"list": [{"name": "x"}], "NAME": "n\u00f6rd"})") ==
        segment + " #n\xC3\xB6rd\n");
  CHECK(named(R"("properties": {"id": null, "name": true})") == segment + "\n");
  CHECK(listed(R"({"id": "a", "type": "Feature", "geometry": )" + geometry + "}") ==
        segment + " #a\n");
  CHECK(named("\"id\": \"" + std::string(2'000, 'x') + "\"") ==
        segment + " #" + std::string(1'000, 'x') + "...\n");
}

TEST_CASE("features in a collection keep their own names, geometries in one are numbered") {
  const std::string two = R"({"type": "GeometryCollection", "geometries": [)" +
                          line("[[0, 0], [1, 1]]") + "," + line("[[2, 2], [3, 3]]") + "]}";
  const std::string features = feature(two, R"("id": 1)") + ",\n" +
                               feature(line("[[4, 4], [5, 5]]"), R"("properties": null)") + ",\n" +
                               feature(line("[[6, 6], [7, 7]]"), R"("id": 3)");
  CHECK(listed(R"({"features": [)" + features + R"(], "id": 99, "type": "FeatureCollection"})") ==
        "0 0, 1 1 | a.geojson:1:15 LineString #1/1\n"
        "2 2, 3 3 | a.geojson:1:15 LineString #1/2\n"
        "4 4, 5 5 | a.geojson:2:1 LineString\n"
        "6 6, 7 7 | a.geojson:3:1 LineString #3\n");
}

TEST_CASE("the reference system that a document names is kept") {
  const auto crs_of = [](const std::string& crs) {
    const auto structure = read_geojson(
        R"({"crs": )" + crs + R"(, "type": "FeatureCollection", "features": [)" +
            feature(line("[[0, 0], [1, 1]]"), R"("crs": {"properties": {"name": "not here"}})") +
            "]}",
        "a.geojson");
    CHECK(segments_of(evaluate(structure)) == "0 0, 1 1\n");
    return structure.crs;
  };
  CHECK(crs_of(R"({"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::3857"}})") ==
        "urn:ogc:def:crs:EPSG::3857");
  CHECK(crs_of(R"({"type": "link", "properties": {"href": "a", "more": {"name": "b"}}})").empty());
  CHECK(crs_of(R"({"name": "b", "properties": {"list": [{"name": "c"}], "name": 7}})").empty());
  CHECK(crs_of("null").empty());
  CHECK(crs_of(R"(["name"])").empty());
}

TEST_CASE("a polygon of several is named by the feature's id and its number") {
  const std::string polygons = R"({"type": "MultiPolygon", "coordinates": [
      [[[0, 0], [4, 0], [4, 4], [0, 0]]], [[[9, 9], [8, 9], [9, 8], [9, 9]]]]})";
  const auto set = evaluate(read_geojson(feature(polygons, R"("id": "lot")"), "a.geojson"));
  REQUIRE(set.sources.size() == 2);
  CHECK(set.sources[0].id == "lot/1");
  CHECK(set.sources[1].id == "lot/2");
}

TEST_CASE("rings are drawn as they are; one that is not closed is listed") {
  CHECK(listed(R"({"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4]], [[1, 1]], []]})") ==
        "0 0, 4 0 | a.geojson:1:1 Polygon\n"
        "4 0, 4 4 | a.geojson:1:1 Polygon\n"
        "rejected:\n"
        "a.geojson:1:1 Polygon: line of a single point: 1 line\n"
        "remarks:\n"
        "a.geojson:1:1 Polygon: ring is not closed; it is drawn as it is: 1 ring\n");
}

TEST_CASE("what is not used or drawn is listed") {
  const auto rejected = [](const std::string& geometry) { return listed(geometry); };
  const std::string at = "rejected:\na.geojson:1:1 ";
  CHECK(rejected(line("[[0, 0, 5], [1, 1, 6, 7]]")) ==
        "0 0, 1 1 | a.geojson:1:1 LineString\nremarks:\na.geojson:1:1 "
        "LineString: coordinates beyond x and y are not used: 1 element from here on\n");
  CHECK(rejected(line("[]")) == at + "LineString: has no points\n");
  CHECK(rejected(line("[[0, 0], [1]]")) == at + "LineString: position of one number\n");
  CHECK(rejected(line("[[0, 0], []]")) == at + "LineString: position without numbers\n");
  CHECK(rejected(line("[[], [0, 0]]")) == at + "LineString: position without numbers\n");
  CHECK(rejected(line("[[0, 0], [[1, 1]]]")) == at + "LineString: positions are nested unevenly\n");
  CHECK(rejected(line("[[0, 0], [1, [1]]]")) ==
        at + "LineString: coordinates hold an array beside numbers\n");
  CHECK(rejected(line("[[[0, 0], [1, 1]]]")) ==
        at + "LineString: coordinates are nested 3 deep, not 2\n");
  CHECK(rejected(line("[[0, \"1\"]]")) ==
        at + "LineString: coordinates hold something other than numbers: 1\n");
  CHECK(rejected(line("[[0, {\"x\": [1]}]]")) == at + "LineString: coordinates hold an object\n");
  CHECK(rejected(line("null")) == at + "LineString: coordinates are not an array: null\n");
  CHECK(rejected(line("{\"x\": [1, 2]}")) == at + "LineString: coordinates are not an array\n");
  CHECK(rejected(line("[[0, 0], [1, 0." + std::string(20'000, '3') + "]]"))
            .starts_with(at + "LineString: number of more than 10000 digits"));
  CHECK(rejected(feature("null", "\"id\": 1")) == at + "Feature: has no geometry: null\n");
  CHECK(rejected(feature("[1, [2]]", "\"id\": 1")) ==
        at + "Feature: its geometry is not an object: an array\n");
}

TEST_CASE("a feature that breaks the format is listed, the others are drawn") {
  const std::string good = feature(line("[[0, 0], [1, 1]]"), R"("id": 1)");
  const auto beside_good = [&](const std::string& bad) {
    return listed(R"({"type": "FeatureCollection", "features": [)" + bad + ",\n" + good + "]}");
  };
  const std::string drawn = "0 0, 1 1 | a.geojson:2:1 LineString #1\nrejected:\n";
  CHECK(beside_good("null") == drawn + "a.geojson:1:48 Feature: not an object: null\n");
  CHECK(beside_good("[{}]") == drawn + "a.geojson:1:44 Feature: not an object: an array\n");
  CHECK(beside_good(R"({"type": "Feature"})") ==
        drawn + "a.geojson:1:44 Feature: no member geometry\n");
  CHECK(beside_good(line("[[0, 0], [1, 1]]")) ==
        drawn + "a.geojson:1:44 LineString: no Feature by its type: LineString\n");
  CHECK(beside_good(R"({"type": "FeatureCollection", "features": [)" + good + "]}") ==
        drawn + "a.geojson:1:44 FeatureCollection: no Feature by its type: FeatureCollection\n");
  CHECK(beside_good(R"({"geometry": )" + line("[[2, 2], [3, 3]]") + "}") ==
        "2 2, 3 3 | a.geojson:1:44 LineString\n0 0, 1 1 | a.geojson:2:1 LineString #1\nremarks:\n"
        "a.geojson:1:44 object: no Feature by its type; what it contains is drawn\n");
  CHECK(beside_good(feature(R"({"type": "Circle", "coordinates": [0, 0]})", R"("id": 2)")) ==
        drawn + "a.geojson:1:76 object: no geometry by its type: Circle\n");
  CHECK(beside_good(feature(good, R"("id": 2)")) ==
        drawn + "a.geojson:1:76 Feature: no geometry by its type: Feature\n");
}

TEST_CASE("a document that is not GeoJSON is refused with its place") {
  CHECK(error_of("") == "a:1:1: not JSON: The document is empty.");
  CHECK(error_of("5") == "a:1:2: not GeoJSON: not a GeoJSON object");
  CHECK(error_of("[{}]").starts_with("a:1:1: not GeoJSON: not a GeoJSON object"));
  CHECK(error_of("{}") == "a:1:2: not GeoJSON: no member type: \"}\"");
  CHECK(error_of(R"({"type": "polygon"})") == "a:1:19: not GeoJSON: unknown type: \"polygon\"");
  CHECK(error_of(R"({"type": 5})") == "a:1:11: not GeoJSON: unknown type: \"5\"");
  CHECK(error_of(R"({"type": "FeatureCollection"})") ==
        "a:1:29: not GeoJSON: FeatureCollection without member features: \"}\"");
  CHECK(error_of("{\"type\": \"Feature\",\n\"type\": \"Feature\"}") ==
        "a:2:7: not GeoJSON: member type is there twice: \": \"Feature\"}\"");
  CHECK(error_of(R"({"coordinates": [], "geometries": []})").find("has two of these") !=
        std::string::npos);
  CHECK(error_of(R"({"features": {}})").find("not an array") != std::string::npos);
}

TEST_CASE("a text that is not JSON is refused with the place and the text") {
  const std::string open = "{\"type\": \"LineString\",\n\"coordinates\": [[0, 1], [";
  CHECK(error_of(open + "NaN, 1]]}") == "a:2:26: not JSON: Invalid value.: \"NaN, 1]]}\"");
  CHECK(error_of(open + "-Infinity, 1]]}").starts_with("a:2:2"));
  CHECK(error_of(open + "01, 1]]}").find("Missing a comma") != std::string::npos);
  CHECK(error_of(open + "1., 1]]}").find("Miss fraction part") != std::string::npos);
  CHECK(error_of(open + "1, 1]]").starts_with("a:2:32: not JSON"));
  CHECK(error_of(open + "1, 1]]} {}").find("must not be followed") != std::string::npos);
  CHECK(error_of("{\"type\": \"Feature\xFF\"}").find("Invalid encoding") != std::string::npos);
  CHECK(error_of(std::string("{\"type\": \"Feature\", \"geometry\": null}\0{}", 40))
            .find("zero byte") != std::string::npos);
  CHECK(error_of(open + std::string(1'000, '9') + ", 0]]}").find("too big") != std::string::npos);
}

TEST_CASE("collections of any depth are read, and too deep ones refused") {
  constexpr std::size_t kDepth = 100'000;
  std::string text;
  for (std::size_t i = 0; i < kDepth; ++i) {
    text += R"({"type": "GeometryCollection", "geometries": [)";
  }
  text += line("[[0, 0], [1, 1]]");
  for (std::size_t i = 0; i < kDepth; ++i) text += "]}";
  CHECK(evaluate(read_geojson(text, "a")).segments.size() == 1);
  CHECK(error_of(std::string(3'000'000, '[')).find("not a GeoJSON object") != std::string::npos);
  CHECK(error_of("{\"x\": " + std::string(3'000'000, '[')).find("JSON nested more than 1000000") !=
        std::string::npos);
}

TEST_CASE("of very many bad items each reason is listed once more, with a count") {
  std::string text = R"({"type": "FeatureCollection", "features": [null)";
  for (int i = 0; i < 12'345; ++i) text += ",null";
  const auto set = evaluate(read_geojson(text + "]}", "a"));
  REQUIRE(set.rejected.size() == 10'001);
  CHECK(set.rejected.back().text == "2346 more like this from here on");
  CHECK(set.rejected.back().reason == "not an object");
}

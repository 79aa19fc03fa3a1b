// GeoJSON texts whose polygons have other rings.

#include <catch2/catch.hpp>
#include <string>

#include "plumbline/patch.hpp"
#include "plumbline/read.hpp"

using namespace plumbline;

namespace {

/// The polygons that are read, as they were drawn.
std::vector<DrawnPolygon> read_polygons(const std::string& text) {
  const SegmentSet input = evaluate(read_geojson(text, "a.geojson"));
  std::vector<DrawnPolygon> result;
  for (const Ring& ring : input.rings) {
    if (ring.role != RingRole::Polygon) continue;
    result.push_back({input.sources[input.segment_source[ring.first]], {}, true, 0});
  }
  return result;
}

const PolygonParts kTriangle{{{{0, 0}, {1, 0}, {0.5, 1}}}};

/// The text with the triangle in place of polygon i.
std::string patched(const std::string& text, std::size_t i, const PolygonParts& parts = kTriangle) {
  std::vector<DrawnPolygon> polygons = read_polygons(text);
  polygons.at(i).parts = parts;
  polygons.at(i).is_as_drawn = false;
  const auto patch = patched_geojson(text, polygons);
  if (!patch) return "none";
  CHECK(patch->replaced.size() == 1);
  return patch->text;
}

const std::string kSquare = R"({"type":"Polygon","coordinates":[[[9,9],[8,9],[8,8],[9,9]]]})";
const std::string kNew = R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0.5,1],[0,0]]]})";

}  // namespace

TEST_CASE("a feature keeps all but its geometry") {
  const std::string head =
      R"({"properties": {"type": "Polygon", "coordinates": "\"}{"}, "bbox": [],)"
      "\n\t\"geometry\" : ";
  const std::string tail = ",\r\n \"id\":1, \"type\": \"Feature\"}\n";
  CHECK(patched(head + kSquare + tail, 0) == head + kNew + tail);
  const std::string mark = "\xEF\xBB\xBF";
  CHECK(patched(mark + head + kSquare + tail, 0) == mark + head + kNew + tail);
  CHECK(patched("  " + kSquare, 0) == "  " + kNew);
}

TEST_CASE("of several features in one line each has its own") {
  const auto feature = [](const std::string& geometry) {
    return R"({"type":"Feature","properties":null,"geometry":)" + geometry + "}";
  };
  const auto both = [&](const std::string& a, const std::string& b) {
    return R"({"features":[)" + feature(a) + "," + feature("null") + "," + feature(b) +
           R"(],"type":"FeatureCollection"})";
  };
  CHECK(patched(both(kSquare, kSquare), 0) == both(kNew, kSquare));
  CHECK(patched(both(kSquare, kSquare), 1) == both(kSquare, kNew));
}

TEST_CASE("in a collection a polygon is found by its order") {
  const auto all = [](const std::string& a, const std::string& b) {
    return R"({"type":"Feature","properties":{},"geometry":{"type":"GeometryCollection","geometries":[)" +
           a + R"(,{"type":"LineString","coordinates":[[0,0],[5,5]]},)" + b + "]}}";
  };
  CHECK(patched(all(kSquare, kSquare), 1) == all(kSquare, kNew));
  // One that was not read has no number.
  const std::string point = R"({"type":"Polygon","coordinates":[]})";
  CHECK(patched(all(point, kSquare), 0) == "none");
}

TEST_CASE("what falls apart is a MultiPolygon, and nothing has no coordinates") {
  PolygonParts parts = kTriangle;
  parts.push_back({{{4, 4}, {5, 4}, {4, 5}}});
  CHECK(patched(kSquare, 0, parts) ==
        R"({"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[0.5,1],[0,0]]],)"
        R"([[[4,4],[5,4],[4,5],[4,4]]]]})");
  CHECK(patched(kSquare, 0, {}) == R"({"type":"Polygon","coordinates":[]})");
}

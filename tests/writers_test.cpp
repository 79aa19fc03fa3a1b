// Files that other programs open: what is in them, and that it is the complex.

#include <rapidjson/document.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "inputs/families.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/engines/files.hpp"
#include "plumbline/features.hpp"
#include "plumbline/output.hpp"
#include "plumbline/read.hpp"
#include "plumbline/structure.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

struct Drawn {
  SegmentSet input;
  ExactComplex complex = arrange(input);
  Rounding rounding = safely_rounded(complex, {});

  FeatureLayer faces() const { return face_layer(complex, input, rounding); }
  FeatureLayer edges() const { return edge_layer(input, rounding); }
};

Features features(std::vector<FeatureLayer> layers) { return {std::move(layers), "", "a note"}; }

const std::string kRooms = rectangle(0, 0, 8, 4) + "4 0 4 4  6 4 6 2  " + rectangle(1, 1, 2, 2);

/// What the tool reads in a file of this content.
SegmentSet read_back(const std::string& name, const std::string& content) {
  const auto file = std::filesystem::temp_directory_path() / ("plumbline_writers_test_" + name);
  std::ofstream(file, std::ios::binary) << content;
  SegmentSet input = evaluate(read(file));
  std::filesystem::remove(file);
  return input;
}

std::size_t count_of(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (auto at = text.find(words); at != text.npos; at = text.find(words, at + 1)) ++count;
  return count;
}

bool has_isolated_vertices(const ExactComplex& complex) {
  return !complex.face_isolated_vertices.flat().empty();
}

/// One input of each family, of those with edges.
std::vector<std::pair<std::string, Drawn>> of_all_families(unsigned seed) {
  std::vector<std::pair<std::string, Drawn>> all;
  for (const std::string& family : inputs::families()) {
    Drawn drawn{inputs::of_family(family, seed)};
    if (drawn.complex.edge_count() == 0 || has_isolated_vertices(drawn.complex)) continue;
    all.emplace_back(family, std::move(drawn));
  }
  return all;
}

using Ring = std::vector<std::pair<double, double>>;
using JsonRing = rapidjson::Value;

Ring ring_of(const JsonRing& points) {
  Ring ring;
  for (const auto& p : points.GetArray()) ring.emplace_back(p[0].GetDouble(), p[1].GetDouble());
  return ring;
}

/// As a client of TopoJSON puts arcs together.
Ring stitched(const rapidjson::Document& topology, const rapidjson::Value& arcs) {
  Ring ring;
  for (const auto& reference : arcs.GetArray()) {
    const int i = reference.GetInt();
    Ring arc = ring_of(topology["arcs"][static_cast<rapidjson::SizeType>(i < 0 ? ~i : i)]);
    if (i < 0) std::reverse(arc.begin(), arc.end());
    if (!ring.empty()) {
      REQUIRE(ring.back() == arc.front());
      ring.pop_back();
    }
    ring.insert(ring.end(), arc.begin(), arc.end());
  }
  return ring;
}

/// A closed ring from its least point on.
Ring from_least(Ring ring) {
  REQUIRE(ring.front() == ring.back());
  ring.pop_back();
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

}  // namespace

TEST_CASE("DXF joins lines of one layer that go on from each other") {
  const auto line = [](PointD a, PointD b, std::string layer) {
    return Feature{{{a, b}}, {}, std::move(layer)};
  };
  const Features drawing =
      features({{"edges",
                 FeatureGeometry::Line,
                 {},
                 {line({0, 0}, {1, 0}, "A"), line({2, 1}, {1, 0}, "A"), line({2, 1}, {3, 1}, "B"),
                  line({5, 5}, {6, 5}, ""), line({6, 5}, {6, 6}, ""), line({6, 6}, {5, 5}, "")}}});
  const std::string dxf = to_dxf(drawing);
  CHECK(count_of(dxf, "\nLINE\n") == 1);
  CHECK(count_of(dxf, "\nLWPOLYLINE\n") == 2);
  CHECK(dxf.find("\n8\nA\n100\nAcDbPolyline\n90\n3\n70\n0\n10\n0.0\n20\n0.0\n10\n1.0\n20\n0.0\n10\n"
                 "2.0\n20\n1.0\n") != dxf.npos);
  CHECK(dxf.find("\n8\nedges\n100\nAcDbPolyline\n90\n3\n70\n1\n") != dxf.npos);  // closed
  CHECK(dxf.starts_with("999\na note\n0\nSECTION\n"));
}

TEST_CASE("layers of DXF have legal names, each its own") {
  const auto point = [](std::string layer) { return Feature{{{{0, 0}}}, {}, std::move(layer)}; };
  const std::string dxf =
      to_dxf(features({{"vertices",
                        FeatureGeometry::Point,
                        {},
                        {point("W\xC3\xA4nde/a:b"), point("walls"), point("WALLS"), point("0"),
                         point("\xF0\x9F\x98\x80")}}}));
  for (const char* name : {"W\\U+00E4nde_a_b", "walls", "WALLS_2", "\\U+FFFD"}) {
    CHECK(count_of(dxf, std::string("\nAcDbLayerTableRecord\n2\n") + name + "\n") == 1);
    CHECK(count_of(dxf, std::string("\n8\n") + name + "\n100\nAcDbPoint") == 1);
  }
  CHECK(count_of(dxf, "\nAcDbLayerTableRecord\n2\n") == 5);
}

TEST_CASE("DXF keeps layers, with the nearest colour that it numbers, and the unit") {
  Features drawing = features({});
  drawing.drawing_layers = {{"a", 0xff0000}, {"b", 0xfe8001}, {"c", {}},
                            {"d", 0},        {"0", 0x0000ff}, {"e", 0x5452a4, true}};
  drawing.unit = {"mm", Rational(1, 1000)};
  const std::string dxf = to_dxf(drawing);
  for (const char* row : {"a\n70\n0\n62\n1", "b\n70\n0\n62\n30", "c\n70\n0\n62\n7",
                          "d\n70\n0\n62\n7", "0\n70\n0\n62\n5", "e\n70\n0\n62\n173"}) {
    CHECK(count_of(dxf, std::string("\nAcDbLayerTableRecord\n2\n") + row + "\n") == 1);
  }
  CHECK(count_of(dxf, "\nAcDbLayerTableRecord\n") == 6);
  CHECK(dxf.find("\n$INSUNITS\n70\n4\n") != dxf.npos);
}

TEST_CASE("edges and faces say the layers of the drawing that they lie on") {
  SegmentSet input;
  const auto add = [&input](const char* layer, int ax, int ay, int bx, int by) {
    const SourceId source = input.add_source({0, 1, 1, "line", "", "", layer});
    input.add({{ax, ay}, {bx, by}}, source);
  };
  add("B", 0, 0, 2, 0);
  add("A", 1, 0, 4, 0);
  add("", 4, 0, 0, 4);
  add("B", 0, 4, 0, 0);
  const Drawn drawn{input};
  const FeatureLayer edges = drawn.edges(), faces = drawn.faces();
  const auto layers_of = [](const FeatureLayer& layer, std::size_t i) {
    const auto column = std::ranges::find(layer.columns, "layers") - layer.columns.begin();
    return std::get<std::string>(layer.features.at(i).values.at(static_cast<std::size_t>(column)));
  };
  REQUIRE(edges.features.size() == 5);  // (0,0)-(0,4), -(1,0), (0,4)-(4,0), (1,0)-(2,0), -(4,0)
  CHECK(layers_of(edges, 0) == "B");
  CHECK(layers_of(edges, 2) == "");
  CHECK(layers_of(edges, 3) == "B; A");
  CHECK(edges.features[3].layer == "B");
  CHECK(edges.features[4].layer == "A");
  CHECK(layers_of(faces, 0) == "B; A");
}

TEST_CASE("DXF has the names of polygons as texts within them") {
  // A U, whose middle is not in it.
  const FeatureLayer rooms{"rooms",
                           FeatureGeometry::Polygon,
                           {"name"},
                           {{{{{0, 0}, {9, 0}, {9, 9}, {8, 9}, {8, 1}, {1, 1}, {1, 9}, {0, 9}}},
                             {"K\xC3\xBC"
                              "che"}},
                            {{{{20, 0}, {21, 0}, {21, 1}}}, {std::monostate()}}}};
  const std::string dxf = to_dxf(features({rooms}));
  CHECK(count_of(dxf, "\nTEXT\n") == 1);
  CHECK(dxf.find("\n1\nK\\U+00FCche\n72\n1\n11\n4.5\n21\n0.5\n") != dxf.npos);
}

TEST_CASE("DXF that is written and read back is the rounded complex") {
  for (const auto& [family, drawn] : of_all_families(21)) {
    INFO(family);
    const SegmentSet read = read_back("e.dxf", to_dxf(features({drawn.edges()})));
    CHECK(read.rejected.empty());
    CHECK(signature(arrange(rounded(read), 1)) == signature(drawn.rounding.complex));
  }
}

TEST_CASE("faces share the arcs of TopoJSON, and are those of GeoJSON") {
  for (const auto& [family, drawn] : of_all_families(22)) {
    INFO(family);
    const Features faces = features({drawn.faces()});
    rapidjson::Document topology, json;
    topology.Parse(to_topojson(faces).c_str());
    json.Parse(to_geojson(faces).c_str());
    REQUIRE(!topology.HasParseError());
    std::set<int> used;
    const auto& polygons = topology["objects"]["faces"]["geometries"];
    REQUIRE(polygons.Size() == json["features"].Size());
    for (rapidjson::SizeType i = 0; i < polygons.Size(); ++i) {
      CHECK(polygons[i]["properties"] == json["features"][i]["properties"]);
      const auto& rings = json["features"][i]["geometry"]["coordinates"];
      REQUIRE(polygons[i]["arcs"].Size() == rings.Size());
      for (rapidjson::SizeType r = 0; r < rings.Size(); ++r) {
        const auto& arcs = polygons[i]["arcs"][r];
        CHECK(from_least(stitched(topology, arcs)) == from_least(ring_of(rings[r])));
        for (const auto& arc : arcs.GetArray()) {
          CHECK(used.insert(arc.GetInt()).second);  // in each direction once
        }
      }
    }
    for (rapidjson::SizeType a = 0; a < topology["arcs"].Size(); ++a) {
      CHECK((used.contains(static_cast<int>(a)) || used.contains(~static_cast<int>(a))));
    }
  }
}

TEST_CASE("an arc of TopoJSON goes from node to node, and ends where a line does") {
  const Drawn rooms{segments(kRooms)};
  rapidjson::Document topology;
  topology.Parse(to_topojson(features({rooms.faces()})).c_str());
  // The closed column; left, right and middle wall of the two rooms: of the dangling wall nothing.
  CHECK(topology["arcs"].Size() == 4);
  topology.Parse(to_topojson(features({rooms.faces(), rooms.edges()})).c_str());
  CHECK(topology["arcs"].Size() == rooms.complex.edge_count());
  const auto& edges = topology["objects"]["edges"]["geometries"];
  REQUIRE(edges.Size() == rooms.complex.edge_count());
  for (const auto& edge : edges.GetArray()) CHECK(edge["arcs"].Size() == 1);
}

TEST_CASE("triangles of OBJ fill the faces") {
  const Drawn rooms{segments(kRooms)};
  std::istringstream lines(to_obj(rooms.rounding));
  std::vector<PointD> points;
  std::vector<double> areas;
  std::size_t edges = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(1));
    if (line.starts_with("v ")) {
      words >> points.emplace_back().x >> points.back().y;
    } else if (line.starts_with("g face")) {
      areas.push_back(0);
    } else if (line.starts_with("l ")) {
      ++edges;
    } else if (line.starts_with("f ")) {
      std::size_t a = 0, b = 0, c = 0;
      words >> a >> b >> c;
      const PointD p = points.at(a - 1), q = points.at(b - 1), r = points.at(c - 1);
      areas.back() += ((q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y)) / 2;
    }
  }
  CHECK(points.size() == rooms.complex.vertices.size());
  CHECK(edges == rooms.complex.edge_count());
  CHECK(areas == std::vector<double>{15, 1, 16});
}

TEST_CASE("a LAR model that is written is the exact complex, for read and for check") {
  for (const auto& [family, drawn] : of_all_families(23)) {
    INFO(family);
    const std::string lar = to_lar_json(drawn.complex);
    CHECK(signature(arrange(read_back("m.lar.json", lar))) == signature(drawn.complex));
    if (!is_kept_by_simple_rounding(drawn.complex, {})) continue;  // which check reads it with
    const auto answer = files::answer(files::read_lar(lar, "m"));
    CHECK(check(drawn.input, drawn.complex, answer).comparison.agree());
  }
}

TEST_CASE("a LAR model has the vertices of each face, and its boundaries where there are holes") {
  const Drawn fractions{segments("0 0 1 0  1 0 1/3 0.5  1/3 0.5 0 0")};
  CHECK(to_lar_json(fractions.complex) ==
        "{\"V\":[\n[0,0],\n[\"1/3\",0.5],\n[1,0]\n],\"FV\":[\n[0,2,1]\n],\"EV\":[\n[0,1],\n[0,2],\n"
        "[1,2]\n]}\n");
  const Drawn rooms{segments(kRooms)};
  rapidjson::Document lar;
  lar.Parse(to_lar_json(rooms.complex).c_str());
  REQUIRE(lar["polygons"].Size() == 3);
  CHECK(lar["polygons"][0].Size() == 2);
  CHECK(lar["FV"][0].Size() == lar["polygons"][0][0].Size() + lar["polygons"][0][1].Size());
}

TEST_CASE("edges are decimals, or not") {
  CHECK(are_decimals(Drawn{segments("0 0 2 1  0 1 1 0")}.complex) == false);
  CHECK(are_decimals(Drawn{segments("0 0 1 0.0078125  -3 1e-7 8/5 3")}.complex));
  CHECK(are_decimals(Drawn{segments("0 0 1 1/7")}.complex) == false);
}

// Results of other programs: what each format says of the same faces.

#include "plumbline/engines/files.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

void add_square(SegmentSet& set, int from, int to) {
  const auto source = set.add_source({});
  const Point a{from, from}, b{to, from}, c{to, to}, d{from, to};
  for (const Segment& s : {Segment{a, b}, Segment{b, c}, Segment{c, d}, Segment{d, a}}) {
    set.add(s, source);
  }
}

/// A square of side 9, and one of side 3 in it.
SegmentSet nested_squares() {
  SegmentSet set;
  add_square(set, 0, 9);
  add_square(set, 3, 6);
  return set;
}

/// The findings of a result of `nested_squares`, "kind disagreement" each.
std::vector<std::string> findings(files::Result result) {
  const SegmentSet input = nested_squares();
  std::vector<std::string> list;
  for (const Finding& f :
       check(input, arrange(input), files::answer(std::move(result))).comparison.findings) {
    list.push_back(to_text(f.kind) + " " + to_text(f.disagreement));
  }
  return list;
}
using Texts = std::vector<std::string>;

/// The place and the first words of the error.
std::string error_of(files::Result (*read)(std::string_view, const std::string&),
                     std::string_view text) {
  try {
    read(text, "f");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

constexpr const char* kVertices = R"("V": [[0,0],[9,0],[9,9],[0,9],[3,3],[6,3],[6,6],[3,6]])";
constexpr const char* kEdges = R"("EV": [[0,1],[1,2],[2,3],[3,0],[4,5],[5,6],[6,7],[7,4]])";

std::string model(const std::string& members) { return "{" + (kVertices + (", " + members)) + "}"; }
files::Result read_lar(const std::string& members) { return files::read_lar(model(members), "f"); }

}  // namespace

TEST_CASE("result: LAR faces with their holes agree, as polygons and as sets of vertices") {
  const std::string polygons = R"(, "polygons": [[[0,1,2,3],[4,5,6,7]],[[4,7,6,5]]])";
  CHECK(findings(read_lar(kEdges + polygons)).empty());
  CHECK(findings(read_lar(polygons.substr(2))).empty());
  CHECK(
      findings(read_lar(kEdges + std::string(R"(, "FV": [[0,1,2,3,4,5,6,7],[4,5,7,6]])"))).empty());
}

TEST_CASE("result: LAR faces as sets of vertices agree where other edges join these, too") {
  // A quadrilateral with a point inside that is joined to three corners, and an edge around.
  SegmentSet drawing;
  const SourceId source = drawing.add_source({});
  for (const Segment& s :
       {Segment{{0, 0}, {4, 0}}, Segment{{4, 0}, {4, 4}}, Segment{{4, 4}, {0, 4}},
        Segment{{0, 4}, {0, 0}}, Segment{{0, 0}, {1, 2}}, Segment{{1, 2}, {4, 4}},
        Segment{{0, 0}, {4, 4}}}) {
    drawing.add(s, source);
  }
  // By coordinates: 0 (0,0), 1 (0,4), 2 (1,2), 3 (4,0), 4 (4,4). The face 0 2 4 1 has the chord
  // 0 4.
  const files::Result result = files::read_lar(
      R"({"V": [[0,0],[0,4],[1,2],[4,0],[4,4]],)"
      R"( "EV": [[0,1],[0,2],[0,3],[0,4],[1,4],[2,4],[3,4]], "FV": [[0,1,2,4],[0,2,4],[0,3,4]]})",
      "f");
  CHECK(compare(arrange(drawing), result.complex, 0).agree());
}

TEST_CASE("result: LAR lists without names, and indices from 1, are understood") {
  const std::string v = std::string(kVertices).substr(5), ev = std::string(kEdges).substr(6);
  const std::string fv = "[[0,1,2,3,4,5,6,7],[4,5,6,7]]";
  CHECK(findings(files::read_lar("[" + v + "," + fv + "," + ev + "]", "f")).empty());
  const files::Result edges = files::read_lar("[" + v + "," + ev + "]", "f");
  CHECK_FALSE(edges.has_faces);
  CHECK(findings(edges).empty());
  const std::string from_1 =
      R"("EV": [[1,2],[2,3],[3,4],[4,1],[5,6],[6,7],[7,8],[8,5]], "FV": [[1,2,3,4,5,6,7,8],[5,6,7,8]])";
  CHECK(findings(read_lar(from_1)).empty());
  CHECK(findings(read_lar(R"("index_base": 1, )" + from_1)).empty());
}

TEST_CASE("result: a hole that LAR's faces do not have is missing") {
  const files::Result result = read_lar(kEdges + std::string(R"(, "FV": [[0,1,2,3],[4,5,6,7]])"));
  CHECK(result.has_faces);
  // Without its hole the outer square overlaps the inner one.
  CHECK(findings(result) ==
        Texts{"edge invalid", "vertex invalid", "face invalid", "hole missing"});
}

TEST_CASE("result: repeated vertices of LAR stay, those of GeoJSON and WKT are one") {
  const files::Result twice = files::read_lar(
      R"({"V": [[0,0],[1,0],[0,1],[1,0],[0,1],[1,1]], "FV": [[0,1,2],[3,5,4]]})", "f");
  CHECK(twice.complex.vertices.size() == 6);
  const files::Result once =
      files::read_wkt("POLYGON((0 0,1 0,0 1,0 0));POLYGON((1 0,1 1,0 1,1 0))", "f");
  CHECK(once.complex.vertices.size() == 4);
  CHECK(validate(once.complex).empty());
}

TEST_CASE("result: polygons agree in every format of features") {
  const std::string outer = "[[[0,0],[0,9],[9,9],[9,0],[0,0]],[[3,3],[6,3],[6,6],[3,6],[3,3]]]";
  const std::string inner = "[[[3,3],[6,3],[6,6],[3,6],[3,3]]]";
  CHECK(findings(files::read_geojson(
                     R"({"type":"MultiPolygon","coordinates":[)" + outer + "," + inner + "]}", "f"))
            .empty());
  CHECK(findings(
            files::read_geojson(
                R"({"type":"GeometryCollection","geometries":[{"type":"Polygon","coordinates":)" +
                    outer + R"(},{"type":"Polygon","coordinates":)" + inner + "}]}",
                "f"))
            .empty());
  const std::string wkt_outer = "((0 0,0 9,9 9,9 0,0 0),(3 3,6 3,6 6,3 6,3 3))";
  const std::string wkt_inner = "((3 3,6 3,6 6,3 6,3 3))";
  CHECK(findings(files::read_wkt("POLYGON" + wkt_outer + "\nPOLYGON" + wkt_inner, "f")).empty());
  CHECK(
      findings(files::read_wkt("MULTIPOLYGON(" + wkt_outer + "," + wkt_inner + ")", "f")).empty());
}

TEST_CASE("result: lines alone have no faces to compare") {
  const files::Result right =
      files::read_wkt("MULTILINESTRING((0 0,9 0,9 9,0 9,0 0),(3 3,6 3,6 6,3 6,3 3))", "f");
  CHECK_FALSE(right.has_faces);
  CHECK(findings(right).empty());
  CHECK(findings(files::read_wkt("LINESTRING(0 0,9 0,9 9,0 9,0 0,3 3,6 3,6 6,3 6,3 3)", "f")) ==
        Texts{"edge extra"});
}

TEST_CASE("result: an edge that crosses another is found, with or without faces") {
  const std::string crossed = R"("EV": [[0,1],[1,2],[2,3],[3,0],[4,6],[5,7],[6,7],[4,5]])";
  const Texts expected = {"edge invalid", "edge missing", "edge missing", "edge extra",
                          "edge extra"};
  CHECK(findings(read_lar(crossed)) == expected);
}

TEST_CASE("result: what arrange writes is read back exactly") {
  SegmentSet set = nested_squares();
  set.add({{0, 1}, {9, 8}}, set.add_source({}));  // meets the inner square in ninths
  const ExactComplex complex = arrange(set);
  const files::Result result = files::read_arrangement(to_json(complex, set), "f");
  CHECK(result.complex.vertices == complex.vertices);
  CHECK(signature(result.complex) == signature(complex));
  CHECK(validate(result.complex).empty());
}

TEST_CASE("result: files are told by their endings, and JSON by its members") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "plumbline_result_test";
  fs::create_directories(folder);
  const auto file = [&](const char* name, const std::string& content) {
    std::ofstream(folder / name) << content;
    return folder / name;
  };
  const std::string faces = kEdges + std::string(R"(, "FV": [[0,1,2,3,4,5,6,7],[4,5,6,7]])");
  CHECK(findings(files::read(file("lar.json", model(faces)))).empty());
  CHECK(findings(files::read(
                     file("trace.json", R"({"outputs": {"larFromLines": )" + model(faces) + "}}")))
            .empty());
  CHECK(findings(files::read(file("csv.csv",
                                  "wkt\n\"POLYGON((0 0,9 0,9 9,0 9,0 0),(3 3,6 3,6 6,3 6,3 3))\"\n"
                                  "\"POLYGON((3 3,6 3,6 6,3 6,3 3))\"\n")))
            .empty());
  CHECK_THROWS_AS(files::read(file("plan.svg", "<svg/>")), Error);
  CHECK_THROWS_AS(files::read(folder / "none.json"), Error);
  fs::remove_all(folder);
}

TEST_CASE("result: malformed LAR is an error at its place") {
  const auto error = [](const std::string& text) { return error_of(files::read_lar, text); };
  CHECK(error(R"({"V": [[0,0],[1,0]], "EV": [[0,2],[0,1]]})") ==
        "f:1:33: not LAR: no such vertex: 2 are counted from 0 (a member index_base of 0 or 1 says "
        "from where): \"2\"");
  CHECK(error(R"({"V": [[0]], "EV": []})") == "f:1:8: not LAR: point of 1 coordinates");
  CHECK(error(R"({"V": [[0,"x"]]})") == "f:1:14: expected a number: \"x\"");
  CHECK(error(R"({"V": [[0,0]], "EV": [[0,0,0]]})") == "f:1:23: not LAR: edge of 3 vertices");
  CHECK(error(R"({"EV": []})") == "f:1:1: not LAR: no member V");
  CHECK(error(R"({"outputs": {"larFromLines": null}})") ==
        "f:1:13: the trace has no larFromLines: the pipeline had no result");
}

TEST_CASE("result: a malformed arrangement is an error at its place") {
  const auto error = [](const std::string& edges, const std::string& face) {
    return error_of(files::read_arrangement,
                    R"({"format":"plumbline arrangement 1","vertices":[{"exact":["0","0"]}],)"
                    R"("edges":[)" +
                        edges + R"(],"faces":[)" + face + "]}");
  };
  const std::string unbounded = R"({"outer":null,"holes":[],"isolated_vertices":[]})";
  CHECK(error("", unbounded) == "no error");
  CHECK(error("", "") == "f:1:89: no unbounded face");
  CHECK(error(R"({"tail":0,"head":1})", unbounded) == "f:1:97: no such vertex: \"1\"");
  CHECK(error("", R"({"outer":[1],"holes":[],"isolated_vertices":[]})") ==
        "f:1:99: face 0, and no other, is without outer boundary");
  CHECK(error("", R"({"outer":null,"holes":[[1]],"isolated_vertices":[]})") ==
        "f:1:115: no such edge: \"1\"");
}

TEST_CASE("result: a compact arrangement is read back as the complex that it was written of") {
  const SegmentSet input = segments(rectangle(0, 0, 9, 9) + rectangle(3, 3, 6, 6) +
                                    "1 1 2 1.5  0 0 1/3 1  20 0 21 0  4 4 5 5  + 5 4  + 30 1");
  const ExactComplex complex = arrange(input);
  const files::Result result = files::read_arrangement(to_compact_json(complex, input), "f");
  CHECK(result.complex.vertices == complex.vertices);
  CHECK(signature(result.complex) == signature(complex));
  CHECK(result.has_faces);
}

TEST_CASE("result: a malformed compact arrangement is an error at its place") {
  const auto error = [](const std::string& edges, const std::string& faces,
                        const std::string& isolated) {
    return error_of(files::read_arrangement,
                    R"({"format":"plumbline compact arrangement 1","vertices":[["0","0"]],)"
                    R"("edges":[)" +
                        edges + R"(],"faces":[)" + faces + R"(],"isolated_vertices":[)" + isolated +
                        "]}");
  };
  CHECK(error("", "[null]", "[0,0]") == "no error");
  CHECK(error("", "", "") == "f:1:87: no unbounded face");
  CHECK(error("[0]", "[null]", "") == "f:1:77: expected two vertices");
  CHECK(error("[0,1]", "[null]", "") == "f:1:81: no such vertex: \"1\"");
  CHECK(error("", "[]", "") == "f:1:88: expected an outer boundary");
  CHECK(error("", "[[1]]", "") == "f:1:89: face 0, and no other, is without outer boundary");
  CHECK(error("", "[null]", "[0]") == "f:1:117: expected a face and a vertex");
  CHECK(error("", "[null]", "[1,0]") == "f:1:119: no such face: \"1\"");
}

TEST_CASE("result: what is left out of a result is listed") {
  const files::Result result =
      files::read_lar(R"({"V": [[0,0],[1,0],[0,1]], "FV": [[0,1,2],[1]], "areas": [1]})", "f");
  REQUIRE(result.rejected.size() == 2);
  CHECK(result.rejected[0].reason == "this member of a LAR model is not understood");
  CHECK(result.rejected[1].text == "1 face");
  const files::Result points = files::read_wkt("POINT(1 1);POLYGON((0 0,1 0,0 1))", "f");
  REQUIRE(points.rejected.size() == 1);
  CHECK(points.rejected[0].harmless);
  REQUIRE(points.remarks.size() == 1);
  CHECK(points.remarks[0].what == "ring is not closed; it is taken as closed");
  CHECK(points.has_faces);
}

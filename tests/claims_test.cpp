// A result is held to what it claims: polygons alone claim faces, and nothing of dangling edges.

#include <catch2/catch.hpp>

#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/engines/files.hpp"
#include "plumbline/output.hpp"
#include "plumbline/read.hpp"

using namespace plumbline;

namespace {

Check held(const std::string& drawing, const std::string& result) {
  const SegmentSet input = evaluate(read_wkt(drawing, "d.wkt"));
  return check(input, arrange(input), files::answer(files::read_wkt(result, "r.wkt")));
}

/// "kind disagreement (x y)", one a line.
std::string findings(const Check& check) {
  std::string text;
  for (const Finding& f : check.comparison.findings) {
    text += to_text(f.kind) + " " + to_text(f.disagreement) + " (" + to_text(f.where) + ")\n";
  }
  return text;
}

// Rooms with dangling walls inside and outside, a bridge to an inner room, a wall apart.
constexpr const char* kWalls =
    "LINESTRING (0 0, 9 0, 9 7, 0 7, 0 0)\nLINESTRING (4 0, 4 7)\nLINESTRING (4 3, 9 3.5)\n"
    "LINESTRING (1 1, 3 2)\nLINESTRING (9 5, 12 6)\nLINESTRING (4 5, 6 6)\n"
    "LINESTRING (0.1 7, 0.1 8, 0.3 6.5)\nLINESTRING (20 20, 21 21)\n"
    "LINESTRING (1 4, 3 4, 3 6, 1 6, 1 4)\nLINESTRING (3 5, 4 5.5)\n";

// What Shapely 1.8.5's polygonize(unary_union(lines)) made of it.
constexpr const char* kRoom =
    "POLYGON ((4 0, 0 0, 0 7, 0.1 7, 0.2333333333333333 7, 4 7, 4 5.5, 4 5, 4 3, 4 0), "
    "(1 4, 3 4, 3 5, 3 6, 1 6, 1 4))\n";
constexpr const char* kRest =
    "POLYGON ((9 3.5, 9 0, 4 0, 4 3, 9 3.5))\n"
    "POLYGON ((9 5, 9 3.5, 4 3, 4 5, 4 5.5, 4 7, 9 7, 9 5))\n"
    "POLYGON ((0.2333333333333333 7, 0.1 7, 0.1 8, 0.2333333333333333 7))\n";
constexpr const char* kInner = "POLYGON ((3 5, 3 4, 1 4, 1 6, 3 6, 3 5))\n";

std::string shapely() { return std::string(kRoom) + kRest + kInner; }

}  // namespace

TEST_CASE("polygons of a drawing with dangles agree where they are right") {
  const Check result = held(kWalls, shapely());
  CHECK(findings(result).empty());
  CHECK(result.comparison.compared == Compared::Faces);
  CHECK(result.comparison.edges_left_out == 6);
  CHECK(to_text(result).starts_with("agree (the result has polygons alone: 6 edges"));
}

TEST_CASE("where a dangling edge ends on a straight side, a polygon needs no vertex") {
  std::string polygons =
      "POLYGON ((3 4, 1 4, 1 6, 3 6, 3 4))\n" + std::string(kRoom) +
      "POLYGON ((9 3.5, 9 0, 4 0, 4 3, 9 3.5))\nPOLYGON ((9 3.5, 4 3, 4 7, 9 7, 9 3.5))\n"
      "POLYGON ((0.2333333333333333 7, 0.1 7, 0.1 8, 0.2333333333333333 7))\n";
  polygons.replace(polygons.find("4 5.5, 4 5, "), 12, "");
  polygons.replace(polygons.find("3 4, 3 5, 3 6"), 13, "3 4, 3 6");
  CHECK(findings(held(kWalls, polygons)).empty());
}

TEST_CASE("what polygons claim wrongly is found, in cells of the whole drawing") {
  const Check lost = held(kWalls, std::string(kRoom) + kRest);
  CHECK(!lost.agree());
  const Check moved = held(kWalls, shapely() + "POLYGON ((30 0, 31 0, 31 1, 30 0))\n");
  CHECK(findings(moved).find("face extra") != std::string::npos);
  // Without the room of the lower right, its face is missing, by its number in the drawing's
  // complex.
  const Check missing = held(
      "LINESTRING (0 0, 1 1)\nLINESTRING (2 0, 3 0, 3 1, 2 0)\nLINESTRING (5 0, 6 0, 6 1, 5 0)",
      "POLYGON ((5 0, 6 0, 6 1, 5 0))");
  const auto& all = missing.comparison.findings;
  const auto face = std::ranges::find(all, CellKind::Face, &Finding::kind);
  REQUIRE(face != all.end());
  CHECK(face->disagreement == Disagreement::Missing);
  REQUIRE(face->exact_cells.size() == 1);
  const FaceId f(face->exact_cells[0]);
  CHECK(locate(missing.exact_complex, {Rational(29, 10), Rational(1, 10)}) == f);
  for (const Finding& finding : all) {
    if (finding.kind != CellKind::Vertex) continue;
    CHECK(missing.exact_complex.vertices[finding.exact_cells.at(0)] == finding.where);
  }
}

TEST_CASE("with lines beside its polygons a result claims dangling edges, too") {
  const Check result = held(kWalls, shapely() + "LINESTRING (1 1, 3 2)");
  CHECK(result.comparison.compared == Compared::All);
  CHECK(!result.agree());
}

TEST_CASE("a vertex that one ring lacks and its neighbour has is one finding") {
  // GEOS #1525.
  const std::string coverage =
      "POLYGON ((1 0, 1 1, 1 3, 4 0, 1 0))\nPOLYGON ((0 4, 1 3, 1 0, 0 4))";
  CHECK(findings(held(coverage, coverage)) == "vertex invalid (1 1)\n");
  CHECK(held(coverage, "POLYGON ((1 0, 1 1, 1 3, 4 0, 1 0))\nPOLYGON ((0 4, 1 3, 1 1, 1 0, 0 4))")
            .agree());
  CHECK(!held(coverage, "POLYGON ((1 0, 0 4, 1 3, 4 0, 1 0))").agree());
  // Several in one side, in rings of either direction.
  const std::string sides =
      "POLYGON ((0 0, 4 0, 4 9, 0 9, 0 0))\nPOLYGON ((4 0, 4 3, 4 6, 4 9, 8 9, 8 0, 4 0))";
  CHECK(findings(held(sides, sides)) == "vertex invalid (4 3)\nvertex invalid (4 6)\n");
}

TEST_CASE("a sliver is no side that lacks a vertex") {
  const std::string sliver =
      "POLYGON ((0 0, 4 0, 4 9, 0 9, 0 0))\nPOLYGON ((4 0, 4.0000000000001 3, 4 9, 4 0))\n"
      "POLYGON ((4 0, 4.0000000000001 3, 4 9, 8 9, 8 0, 4 0))";
  CHECK(held(sliver, sliver).agree());
}

TEST_CASE("some of the faces: each is one of the drawing's, whatever else there is") {
  const SegmentSet input = evaluate(read_wkt(kWalls, "d.wkt"));
  const auto some = [&](files::Result result) {
    Answer answer = files::answer(std::move(result));
    answer.compared = Compared::SomeFaces;
    return check(input, arrange(input), std::move(answer));
  };
  const Check two = some(files::read_wkt(std::string(kRoom) + kInner, "r.wkt"));
  CHECK(two.agree());
  CHECK(two.comparison.matched_faces == 2);
  CHECK(to_text(two).starts_with("agree (2 of the result's faces are faces of the drawing"));
  // A chain of LAR: V, some FV, all EV; a room and the same without its inner room.
  const std::string model =
      R"({"V": [[0,0],[4,0],[4,7],[0,7],[9,0],[9,3.5],[4,3]], "FV": [[1,4,5,6]],
          "EV": [[0,1],[1,6],[6,2],[2,3],[3,0],[1,4],[4,5],[5,6]]})";
  CHECK(some(files::read_lar(model, "m.json")).agree());
  CHECK(findings(some(files::read_wkt("POLYGON ((4 0, 0 0, 0 7, 4 7, 4 0))", "r"))) ==
        "face extra (0 7)\n");
  CHECK(findings(some(files::read_wkt("POLYGON ((9 3.5, 9 0, 4 0, 4 3.125, 9 3.5))", "r"))) ==
        "face extra (4 3.125)\n");
  CHECK(findings(some(files::read_wkt(std::string(kInner) + kInner, "r"))).find("face extra") == 0);
}

namespace {

Check some_held(const std::string& drawing, const std::string& result) {
  const SegmentSet input = evaluate(read_wkt(drawing, "d.wkt"));
  Answer answer = files::answer(files::read_wkt(result, "r.wkt"));
  answer.compared = Compared::SomeFaces;
  return check(input, arrange(input), std::move(answer));
}

constexpr const char* kSquare = "LINESTRING (0 0, 4 0, 4 4, 2 4, 0 4, 0 0)";

}  // namespace

TEST_CASE("a chosen face that is none of the drawing's has its area") {
  const Check result = some_held(kSquare, "POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0))");
  REQUIRE(result.groups.size() == 1);
  REQUIRE(result.groups[0].faces.size() == 1);
  CHECK(result.groups[0].faces[0].areas == std::vector<double>{12});
  CHECK(result.groups[0].area == 12);
}

TEST_CASE("a spike of a chosen face is an edge of the drawing, or wrong") {
  for (const char* spike : {"POLYGON ((0 0, 4 0, 4 4, 2 4, 2 9, 2 4, 0 4, 0 0))",
                            "POLYGON ((0 0, 4 0, 4 4, 2 4, 2 3, 2 4, 0 4, 0 0))"}) {
    INFO(spike);
    CHECK_FALSE(some_held(kSquare, spike).agree());
  }
  CHECK(some_held(std::string(kSquare) + "\nLINESTRING (2 4, 2 3)",
                  "POLYGON ((0 0, 4 0, 4 4, 2 4, 2 3, 2 4, 0 4, 0 0))")
            .agree());
}

namespace {

// Three medians through one point, which doubles take apart.
constexpr const char* kMedians =
    "LINESTRING (500001.3 5000003.7, 500001.0 5000002.8)\n"
    "LINESTRING (500000.7 5000001.9, 500001.5 5000001.35)\n"
    "LINESTRING (500002.3 5000000.8, 500001.8 5000002.25)\n"
    "LINESTRING (500001.0 5000002.8, 500000.7 5000001.9)\n"
    "LINESTRING (500001.5 5000001.35, 500002.3 5000000.8)\n"
    "LINESTRING (500001.8 5000002.25, 500001.3 5000003.7)\n"
    "LINESTRING (500002.3 5000000.8, 500001.0 5000002.8)\n"
    "LINESTRING (500001.3 5000003.7, 500001.5 5000001.35)\n"
    "LINESTRING (500000.7 5000001.9, 500001.8 5000002.25)\n";
// The faces of the exact arrangement of the doubles.
constexpr const char* kOverDoubles =
    "POLYGON((500001.0 5000002.8,500000.7 5000001.9,500001.4333333332 "
    "5000002.133333334,500001.0 5000002.8))\n"
    "POLYGON((500001.4333333332 5000002.133333334,500000.7 5000001.9,500001.5 "
    "5000001.35,500001.43333333335 5000002.133333333,500001.4333333332 5000002.133333334))\n"
    "POLYGON((500001.3 5000003.7,500001.0 5000002.8,500001.4333333332 "
    "5000002.133333334,500001.4333333333 5000002.133333334,500001.3 5000003.7))\n"
    "POLYGON((500001.3 5000003.7,500001.4333333333 5000002.133333334,500001.8 "
    "5000002.25,500001.3 5000003.7))\n"
    "POLYGON((500001.4333333333 5000002.133333334,500001.4333333332 "
    "5000002.133333334,500001.43333333335 5000002.133333333,500001.4333333333 "
    "5000002.133333334))\n"
    "POLYGON((500001.4333333333 5000002.133333334,500001.43333333335 "
    "5000002.133333333,500002.3 5000000.8,500001.8 5000002.25,500001.4333333333 "
    "5000002.133333334))\n"
    "POLYGON((500001.43333333335 5000002.133333333,500001.5 5000001.35,500002.3 "
    "5000000.8,500001.43333333335 5000002.133333333))\n";

}  // namespace

TEST_CASE("what rounding alone makes is not its maker's, a new sliver neither") {
  const Check result = held(kMedians, kOverDoubles);
  REQUIRE_FALSE(result.agree());
  for (const Cause& cause : result.causes) CHECK(cause.stage == kParse);
}

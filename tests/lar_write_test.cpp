// Traces of the float pipeline as JSON, and its pictures.

#include <catch2/catch.hpp>
#include <pugixml.hpp>
#include <set>

#include "engines/lar/show/solid.hpp"
#include "plumbline/engines/lar_show.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"
#include "plumbline/read.hpp"
#include "plumbline/structure.hpp"
#include "support/recorded.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

/// Two rooms, a hole in one, a dangling edge.
const std::string kRooms = rectangle(0, 0, 8, 8) + "0 4 8 4  " + rectangle(1, 1, 2, 2) + "8 8 9 9";

rapidjson::Document parsed(const std::string& json) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseFullPrecisionFlag>(json.c_str());
  REQUIRE(!document.HasParseError());
  return document;
}

std::string text(const rapidjson::Value& value) { return value.GetString(); }

std::size_t count(const std::string& svg, const char* xpath) {
  pugi::xml_document document;
  REQUIRE(document.load_string(svg.c_str()));
  return document.select_nodes(xpath).size();
}

std::string drawn(LarShow show, double explode = 1.2) {
  return to_svg(lar::arrange(segments(kRooms)), {show, explode, false});
}

std::string published_picture(LarShow show) {
  return to_svg(inters::run(inters::lines(segments(kRooms))), {show, 1.2, false});
}

}  // namespace

TEST_CASE("the trace of the repaired variant has every stage under the original's keys") {
  const rapidjson::Document trace = parsed(to_json(lar::arrange(segments(kRooms))));
  CHECK(text(trace["variant"]) == "repaired");
  CHECK(trace["settled"].GetBool());
  CHECK(trace["input"]["EV"].Size() == 10);
  const auto& outputs = trace["outputs"];
  REQUIRE(outputs["rounds"].Size() == 2);
  const auto& round = outputs["rounds"][0];
  CHECK(round["boxes"].Size() == 10);
  CHECK(round["cutPoints"].Size() == 2);
  CHECK(round["prune"]["vmap"].Size() == round["raw"]["V"].Size());
  CHECK(round["lar"]["V"].Size() == 11);
  CHECK(round["lar"]["EV"].Size() == 12);
  CHECK(outputs["components"].Size() == 2);
  CHECK(outputs["bridges"].Size() == 1);
  CHECK(outputs["VE"].Size() == 11);
  CHECK(outputs["cycles"].Size() == outputs["areas"].Size());
  CHECK(outputs["larFromLines"]["V"].Size() == 11);
  CHECK(outputs["larFromLines"]["FV"].Size() == 3);
  std::multiset<std::size_t> boundaries;
  for (const auto& face : outputs["larFromLines"]["polygons"].GetArray()) {
    boundaries.insert(face.Size());
  }
  CHECK(boundaries == std::multiset<std::size_t>{1, 1, 2});
}

TEST_CASE("the trace of the published variant names what is missing and why") {
  const rapidjson::Document trace = parsed(
      to_json(inters::run(inters::lines(segments("0 0.7 1 0.7  2 0.7 3 0.7  4 0.7 5 0.7")))));
  CHECK(text(trace["variant"]) == "published");
  CHECK(trace["decimals"].GetInt() == 4);
  CHECK(trace["input"]["lines"].Size() == 3);
  CHECK(trace["outputs"].MemberCount() == 1);
  CHECK(text(trace["errors"]["buckets"]["error"]) == "IndexError");
  CHECK(text(trace["errors"]["buckets"]["in"]) == "centroid");
}

TEST_CASE("pictures have an element per cell") {
  CHECK(count(drawn(LarShow::Buckets), "//path") == 10);
  CHECK(count(drawn(LarShow::Components), "//path") == 12);
  CHECK(count(drawn(LarShow::Components), "//path[@stroke-dasharray]") == 1);
  CHECK(count(drawn(LarShow::Faces), "//path[@fill-rule]") == 3);
  CHECK(count(drawn(LarShow::Explode), "//path") == 3);
  CHECK(count(drawn(LarShow::Numbers), "//text") == 11 + 12 + 3);
  CHECK(count(published_picture(LarShow::Faces), "//path[@fill-rule]") == 2);
  CHECK(count(published_picture(LarShow::Components), "//path[@stroke-dasharray]") == 1);
  CHECK(count(published_picture(LarShow::Numbers), "//text") == 11 + 12 + 2);
}

TEST_CASE("the picture of pruning has the clusters, their radii and centroids") {
  const SegmentSet slot = segments("0 0 0 1  0.0005 0 0.0005 1  -1 0 1 0  -1 1 1 1");
  const std::string repaired = to_svg(lar::arrange(slot, {0.001}), {LarShow::Pruning, 1, false});
  const std::string original =
      to_svg(inters::run(inters::lines(slot)), {LarShow::Pruning, 1, false});
  // Vertices, members, centroids. As published, the feet at 0.0005 are beside their rounded
  // parameters on the beams, at 0.0006.
  CHECK(count(repaired, "//circle") == 8 + 4 + 2);
  CHECK(count(original, "//circle") == 10 + 6 + 2);
}

TEST_CASE("pictures of nothing are pictures") {
  for (const LarShow show :
       {LarShow::Buckets, LarShow::Components, LarShow::Faces, LarShow::Explode, LarShow::Numbers,
        LarShow::Pruning, LarShow::Filled, LarShow::Polylines, LarShow::Boundary}) {
    CHECK(count(to_svg(lar::arrange(segments("")), {show, 2, true}), "/svg") == 1);
    CHECK(count(to_svg(inters::run({}), {show, 2, true}), "/svg") == 1);
  }
}

TEST_CASE("an exploded view leaves gaps that grow with its factor") {
  CHECK(drawn(LarShow::Explode, 1) != drawn(LarShow::Explode, 1.5));
  CHECK_THROWS_AS(drawn(LarShow::Explode, 0.5), Error);
}

TEST_CASE("a drawing with y upwards is a drawing turned over") {
  const lar::Result result = lar::arrange(segments("0 0 4 0  4 0 4 3"));
  CHECK(to_svg(result, {LarShow::Buckets, 1, false}).find("M20 140L980 140") != std::string::npos);
  CHECK(to_svg(result, {LarShow::Buckets, 1, true}).find("M20 860L980 860") != std::string::npos);
}

namespace {

double area(const std::vector<svg::TriangleD>& triangles) {
  double doubled = 0;
  for (const auto& [p, q, r] : triangles) {
    doubled += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }
  return doubled / 2;
}

std::string boundary_picture(const std::vector<std::size_t>& faces) {
  return to_svg(lar::arrange(segments(kRooms)), {LarShow::Boundary, 1.2, false, faces});
}

}  // namespace

TEST_CASE("filled faces have their areas, holes left out, in as many triangles as there must be") {
  const auto fillings = svg::fillings(lar::arrange(segments(kRooms)));
  std::multiset<double> areas;
  std::multiset<std::size_t> triangles;
  for (const auto& face : fillings) {
    areas.insert(area(face));
    triangles.insert(face.size());
  }
  CHECK(areas == std::multiset<double>{1, 31, 32});
  CHECK(triangles == std::multiset<std::size_t>{2, 2, 8});  // vertices + 2 holes - 2
  CHECK(count(drawn(LarShow::Filled), "//g/path") == 12);
}

TEST_CASE("published fillings are those of its cells where all cycles are simple") {
  const std::string nested = rectangle(0, 0, 8, 8) + rectangle(1, 2, 3, 5);
  const inters::Trace trace = inters::run(inters::lines(segments(nested)));
  REQUIRE(trace.two_complex);
  const auto fillings = svg::fillings(trace);
  REQUIRE(fillings.size() == 1);
  CHECK(area(fillings[0]) == 64 - 6);
  CHECK(fillings[0].size() == 8);
  // Else of the faces of the result, which have no holes.
  const auto rooms = svg::fillings(inters::run(inters::lines(segments(kRooms))));
  REQUIRE(rooms.size() == 2);
  CHECK(area(rooms[0]) == 32);
}

TEST_CASE("a face whose edges cross is not filled, and is drawn in the second colour") {
  inters::Trace trace;
  trace.lines = {{{0, 0}, {1, 1}}};
  trace.lar_from_lines.emplace();
  trace.lar_from_lines->vertices = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  const std::vector<VertexId> bow_tie{VertexId(0), VertexId(1), VertexId(2), VertexId(3)};
  trace.lar_from_lines->faces.push_back(bow_tie);
  CHECK(svg::fillings(trace)[0].empty());
  CHECK(count(to_svg(trace, {LarShow::Filled}), "//path[@stroke='#d55e00']") == 1);
}

TEST_CASE("single polylines walk their bridge twice, one bridge for a hole") {
  const auto faces = svg::bridged(lar::arrange(segments(kRooms)));
  std::multiset<std::size_t> points, bridges;
  for (const svg::Bridged& face : faces) {
    REQUIRE(face.polylines.size() == 1);
    points.insert(face.polylines[0].size());
    bridges.insert(face.bridges.size());
  }
  CHECK(bridges == std::multiset<std::size_t>{0, 0, 1});
  CHECK(points == std::multiset<std::size_t>{5, 5, 4 + 4 + 2 + 1});
  CHECK(count(drawn(LarShow::Polylines), "//path[@stroke='#d55e00']") == 1);
}

TEST_CASE("the boundary of chosen faces is drawn, common edges are not in it") {
  const char* const marked = "//path[@stroke='#d55e00']";
  std::multiset<std::size_t> sizes;
  for (const std::size_t face : {0U, 1U, 2U}) {
    sizes.insert(count(boundary_picture({face}), marked));
  }
  CHECK(sizes == std::multiset<std::size_t>{4, 4, 8});
  CHECK(count(boundary_picture({0, 1, 2}), marked) == 6);
  CHECK(boundary_picture({}) == boundary_picture({0, 1, 2}));
  CHECK(count(boundary_picture({1}), "//text") == 3);
  CHECK_THROWS_WITH(boundary_picture({3}), Catch::Contains("no such face"));
  CHECK(count(published_picture(LarShow::Boundary), marked) == 6);
}

TEST_CASE("random segments as rows are read back as the same doubles") {
  const std::vector<SegmentD> lines = random_lines(100, 0.1, 3);
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / "plumbline_lar_write_test.lines";
  write_file(file, to_lines(lines));
  CHECK(inters::lines(evaluate(read(file))) == lines);
  std::filesystem::remove(file);
  CHECK(to_lines(std::span<const SegmentD>()).empty());
}

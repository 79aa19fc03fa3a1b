#include "plumbline/engines/lar_show.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "engines/lar/show/result_scene.hpp"
#include "support/drawn.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

std::string drawn(LarShow show, double explode = 1.2) {
  return to_svg(lar::arrange(segments(kRooms)), {show, explode, false});
}

}  // namespace

TEST_CASE("the trace has every stage under the original's keys") {
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

TEST_CASE("pictures have an element per cell") {
  CHECK(count(drawn(LarShow::Buckets), "//path") == 10);
  CHECK(count(drawn(LarShow::Components), "//path") == 12);
  CHECK(count(drawn(LarShow::Components), "//path[@stroke-dasharray]") == 1);
  CHECK(count(drawn(LarShow::Faces), "//path[@fill-rule]") == 3);
  CHECK(count(drawn(LarShow::Explode), "//path") == 3);
  CHECK(count(drawn(LarShow::Numbers), "//text") == 11 + 12 + 3);
}

TEST_CASE("the picture of pruning has the clusters, their radii and centroids") {
  const SegmentSet slot = segments("0 0 0 1  0.0005 0 0.0005 1  -1 0 1 0  -1 1 1 1");
  const std::string picture = to_svg(lar::arrange(slot, {0.001}), {LarShow::Pruning, 1, false});
  CHECK(count(picture, "//circle") == 8 + 4 + 2);  // vertices, members, centroids
}

TEST_CASE("pictures of nothing are pictures") {
  for (const LarShow show :
       {LarShow::Buckets, LarShow::Components, LarShow::Faces, LarShow::Explode, LarShow::Numbers,
        LarShow::Pruning, LarShow::Filled, LarShow::Polylines, LarShow::Boundary}) {
    CHECK(count(to_svg(lar::arrange(segments("")), {show, 2, true}), "/svg") == 1);
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

std::string boundary_picture(const std::vector<std::size_t>& faces) {
  return to_svg(lar::arrange(segments(kRooms)), {LarShow::Boundary, 1.2, false, faces});
}

}  // namespace

TEST_CASE("filled faces have their areas, holes left out, in as many triangles as there must be") {
  const lar::Result result = lar::arrange(segments(kRooms));
  const auto fillings = svg::scene(result).fillings();
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

TEST_CASE("single polylines walk their bridge twice, one bridge for a hole") {
  const lar::Result result = lar::arrange(segments(kRooms));
  const auto faces = svg::scene(result).bridged();
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
}

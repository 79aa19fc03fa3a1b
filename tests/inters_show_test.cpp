#include "plumbline/engines/inters_show.hpp"

#include <catch2/catch.hpp>

#include "engines/inters/show/scene.hpp"
#include "support/drawn.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

std::string drawn(LarShow show) {
  return to_svg(inters::run(inters::lines(segments(kRooms))), {show, 1.2, false});
}

}  // namespace

TEST_CASE("the trace names what is missing and why") {
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
  CHECK(count(drawn(LarShow::Faces), "//path[@fill-rule]") == 2);
  CHECK(count(drawn(LarShow::Components), "//path[@stroke-dasharray]") == 1);
  CHECK(count(drawn(LarShow::Numbers), "//text") == 11 + 12 + 2);
  CHECK(count(drawn(LarShow::Boundary), "//path[@stroke='#d55e00']") == 6);
}

TEST_CASE("the picture of pruning has the clusters, their radii and centroids") {
  const SegmentSet slot = segments("0 0 0 1  0.0005 0 0.0005 1  -1 0 1 0  -1 1 1 1");
  const std::string picture =
      to_svg(inters::run(inters::lines(slot)), {LarShow::Pruning, 1, false});
  // Vertices, members, centroids. The feet at 0.0005 are beside their rounded parameters on the
  // beams, at 0.0006.
  CHECK(count(picture, "//circle") == 10 + 6 + 2);
}

TEST_CASE("pictures of nothing are pictures") {
  for (const LarShow show :
       {LarShow::Buckets, LarShow::Components, LarShow::Faces, LarShow::Explode, LarShow::Numbers,
        LarShow::Pruning, LarShow::Filled, LarShow::Polylines, LarShow::Boundary}) {
    CHECK(count(to_svg(inters::run({}), {show, 2, true}), "/svg") == 1);
  }
}

TEST_CASE("fillings are those of its cells where all cycles are simple") {
  const std::string nested = rectangle(0, 0, 8, 8) + rectangle(1, 2, 3, 5);
  const inters::Trace trace = inters::run(inters::lines(segments(nested)));
  REQUIRE(trace.two_complex);
  const auto fillings = svg::scene(trace).fillings();
  REQUIRE(fillings.size() == 1);
  CHECK(area(fillings[0]) == 64 - 6);
  CHECK(fillings[0].size() == 8);
  // Else of the faces of the result, which have no holes.
  const inters::Trace two = inters::run(inters::lines(segments(kRooms)));
  const auto rooms = svg::scene(two).fillings();
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
  CHECK(svg::scene(trace).fillings()[0].empty());
  CHECK(count(to_svg(trace, {LarShow::Filled}), "//path[@stroke='#d55e00']") == 1);
}

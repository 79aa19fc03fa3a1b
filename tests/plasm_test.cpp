// The stages of Plasm.jl's arrangement, each on what was worked out by hand from the rules of the
// original (version 1.0.4).

#include <catch2/catch.hpp>
#include <cmath>

#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/engines/plasm_stages.hpp"
#include "support/segments.hpp"

using namespace plumbline;
using plasm::Chain;
using plasm::Meeting;

namespace {

plasm::Graph graph_of(const std::string& drawing) { return plasm::to_doubles(segments(drawing)); }
std::vector<EdgeId> all_edges(const plasm::Graph& graph) {
  std::vector<EdgeId> all;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) all.emplace_back(e);
  return all;
}
Chain chain(const std::vector<int>& signed_numbers) {
  Chain result;
  for (const int n : signed_numbers) {
    result.push_back({EdgeId(static_cast<std::size_t>(std::abs(n) - 1)), n < 0 ? -1 : 1});
  }
  return result;
}
Check checked(const std::string& drawing, double radius = plasm::kRadius) {
  const SegmentSet input = segments(drawing);
  return check(input, arrange(input), answer_of(plasm::engine(), input, {{"radius", radius}}));
}

}  // namespace

TEST_CASE("vertices are numbered as they come, edges from the lesser number") {
  const plasm::Graph graph = graph_of("1 1 0 0  0 0 2 0  2 0 1 1  3 3 3 3  + 7 7  -0 0 1 1");
  CHECK(graph.vertices == std::vector<PointD>{{1, 1}, {0, 0}, {2, 0}});
  REQUIRE(graph.edges.size() == 4);
  CHECK(graph.edges[2] == plasm::VertexPair{VertexId(0), VertexId(2)});
  CHECK(graph.edges[3] == graph.edges[0]);
  SegmentSet large;
  large.segments.push_back({exact(PointD{0, 0}), exact(PointD{1e200, 0})});
  CHECK_THROWS_AS(plasm::to_doubles(large), Error);
}

TEST_CASE("edges meet where both parameters are within the radius, whatever their lengths") {
  const Meeting crossing = plasm::meet({{0, 0}, {4, 0}}, {{1, -1}, {1, 3}}, 1e-8);
  CHECK(crossing.kind == Meeting::Kind::Crossing);
  REQUIRE(crossing.cuts.size() == 1);
  CHECK(crossing.cuts[0].parameter == 0.25);
  CHECK(crossing.cuts[0].point == PointD{1, 0});
  CHECK(crossing.on_second == 0.25);
  // An end 1/2 short of an edge, by a twentieth of its length.
  CHECK(plasm::meet({{0, 0}, {4, 0}}, {{1, 0.5}, {1, 10.5}}, 0.04).cuts.empty());
  CHECK(plasm::meet({{0, 0}, {4, 0}}, {{1, 0.5}, {1, 10.5}}, 0.06).cuts.size() == 1);
  // On that edge itself the cut lies before its start.
  CHECK(plasm::meet({{1, 0.5}, {1, 10.5}}, {{0, 0}, {4, 0}}, 0.06).cuts[0].parameter == -0.05);
}

TEST_CASE("edges at a small angle are parallel; collinear ones cut each other at their ends") {
  // cos(1e-4) is 1 - 5e-9, cos(2e-4) is 1 - 2e-8.
  CHECK(plasm::meet({{0, 0}, {2, 0}}, {{-0.01, -1e-5}, {0.19, 1e-5}}, 1e-8).kind ==
        Meeting::Kind::Parallel);
  CHECK(plasm::meet({{0, 0}, {2, 0}}, {{1, -2e-5}, {1.2, 2e-5}}, 1e-8).cuts.size() == 1);
  const Meeting overlap = plasm::meet({{0, 0}, {2, 0}}, {{1, 5e-5}, {3, 5e-5}}, 1e-8);
  CHECK(overlap.kind == Meeting::Kind::Collinear);
  REQUIRE(overlap.cuts.size() == 1);
  CHECK(overlap.cuts[0].point == PointD{1, 5e-5});
  CHECK(plasm::meet({{0, 0}, {2, 0}}, {{1, 5e-4}, {3, 5e-4}}, 1e-8).kind ==
        Meeting::Kind::Parallel);
  CHECK(plasm::meet({{0, 0}, {2, 0}}, {{0, 1e-9}, {3, 1e-9}}, 1e-8).kind ==
        Meeting::Kind::Collinear);
}

TEST_CASE("each piece has vertices of its own; equal parameters are one cut, others are not") {
  const plasm::Graph pieces = plasm::fragment(graph_of("0 0 4 0  1 -1 1 1  1 -2 1 2"), 1e-8);
  CHECK(pieces.vertices.size() == 4 + 3 + 5);
  CHECK(pieces.edges.size() == 2 + 2 + 4);
  CHECK(pieces.edge_sources.size() == pieces.edges.size());
  CHECK_THROWS_AS(plasm::fragment(graph_of("0 0 4 0  1 -1 1 1  2 -2 2 2"), 1e-8, 3), Error);
}

TEST_CASE("boxes are not grown: what stops short of an upright edge does not meet it") {
  CHECK(plasm::partners(graph_of("0 0 2 0  1 0.000000005 1 1"))[0].empty());
  CHECK(plasm::partners(graph_of("0 0 2 0  1 0 1 1"))[0].size() == 1);
}

TEST_CASE("the first vertex takes all within the radius, and the next one takes them back") {
  plasm::Graph row;
  for (const double x : {0.0, 0.09, 0.18, 0.27}) row.vertices.push_back({x, 0});
  row.edges = {{VertexId(0), VertexId(1)}, {VertexId(1), VertexId(2)}, {VertexId(2), VertexId(3)}};
  for (std::size_t s = 0; s < 3; ++s) row.edge_sources.push_back(std::array{SegmentId(s)});
  const plasm::Merging merging = plasm::merge(row, 0.1);
  CHECK(merging.graph.vertices == std::vector<PointD>{{0, 0}, {0.18, 0}});
  CHECK(merging.vertex_map[1] == VertexId(1));  // 0 took it first, 0.18 took it last
  CHECK(merging.graph.edges.size() == 1);
}

TEST_CASE("components of two and more edges, most edges first; the others are dropped") {
  const auto found = plasm::biconnected_components(
      graph_of("0 0 1 0  1 0 0 1  0 1 0 0  5 5 6 5  9 0 8 0  8 0 8 1  8 1 9 1  9 1 9 0  1 0 3 0"));
  REQUIRE(found.components.size() == 2);
  CHECK(found.components[0].size() == 4);
  CHECK(found.components[1] == std::vector<EdgeId>{EdgeId(0), EdgeId(1), EdgeId(2)});
  CHECK(found.dropped == std::vector<EdgeId>{EdgeId(3), EdgeId(8)});
}

TEST_CASE("faces grow from the first edge that has none; the unbounded one is the negative one") {
  // A square with a diagonal: vertices (0,0), (1,0), (1,1), (0,1).
  const plasm::Graph graph = graph_of("0 0 1 0  1 0 1 1  1 1 0 1  0 1 0 0  0 0 1 1");
  const auto faces = plasm::minimal_cycles(graph, all_edges(graph));
  REQUIRE(faces.size() == 3);
  CHECK(faces[0] == chain({1, 2, -5}));
  CHECK(faces[1] == chain({3, -4, 5}));
  CHECK(faces[2] == chain({-1, -2, -3, 4}));
  CHECK(plasm::face_area(graph, faces[0]) == 0.5);
  CHECK(plasm::face_area(graph, faces[2]) == -1);
  CHECK(plasm::unbounded_face(graph, all_edges(graph), faces) == 2);
}

TEST_CASE("a point is inside by parity, and not on an edge or at a vertex") {
  const plasm::Graph graph = graph_of("-2 0 0 -2  0 -2 2 0  2 0 0 2  0 2 -2 0");
  const Chain diamond = chain({1, 2, 3, 4});
  CHECK(plasm::is_inside({0, 0}, graph, diamond));
  CHECK(plasm::is_inside({1, 0}, graph, diamond));
  for (const PointD& p : {PointD{-3, 0}, {3, 0}, {2, 0}, {1, 1}, {0, 2}, {-1, 2}, {-3, -2}}) {
    CHECK_FALSE(plasm::is_inside(p, graph, diamond));
  }
}

TEST_CASE("where every edge is in a cycle and all is far apart the result is right") {
  CHECK(checked(rectangle(0, 0, 4, 4)).agree());
  CHECK(checked(rectangle(0, 0, 9, 9) + rectangle(1, 1, 3, 3) + rectangle(5, 5, 8, 8) +
                rectangle(6, 6, 7, 7))
            .agree());
  CHECK(checked("0 0 4 0  4 0 4 4  4 4 0 4  0 4 0 0  0 0 4 4  0 4 4 0  1 1 1 3").agree());
  CHECK(checked("0 0 3 0  3 0 3 3  3 3 0 3  0 3 0 0  0 1 2 1  1 1 3 1").agree());
}

TEST_CASE("a radius must be one") {
  CHECK_THROWS_AS(plasm::run(segments("0 0 1 1"), -1), Error);
  CHECK_THROWS_AS(plasm::run(segments("0 0 1 1"), std::nan("")), Error);
  // Without a radius nothing is parallel, and equal vertices are one all the same.
  CHECK(checked(rectangle(0, 0, 4, 4), 0).agree());
}

TEST_CASE("where there is no cycle there is no result, and vertices and edges are compared") {
  const plasm::Trace trace = plasm::run(segments("0 0 4 4  0 4 4 0"));
  REQUIRE(trace.failure);
  CHECK(trace.failure->kind == plasm::Failure::Kind::NoCycle);
  CHECK(trace.merging.graph.vertices.size() == 5);
  CHECK(plasm::run(segments("")).failure);
}

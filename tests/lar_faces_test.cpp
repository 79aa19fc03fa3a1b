// Stages of the repaired float pipeline from the graph to its faces: components, edge order, face
// walk, containment.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "support/lar_graph.hpp"

using namespace plumbline;
using namespace plumbline::lar;

TEST_CASE("blocks share cut vertices, and bridges are edges in no cycle") {
  const Biconnected blocks = biconnected_components(
      split_graph("0 0 1 1  1 1 1 -1  1 -1 0 0  0 0 -1 1  -1 1 -1 -1  -1 -1 0 0  1 1 3 3  + 8 8"));
  REQUIRE(blocks.components.size() == 2);
  CHECK(blocks.components[0].size() == 3);
  CHECK(blocks.components[1].size() == 3);
  CHECK(blocks.bridges.size() == 1);
}

TEST_CASE("edges around a vertex are in counter-clockwise order from slope -pi") {
  const Graph g = split_graph("0 0 1 0  0 0 1 1  0 0 0 1  0 0 -1 0  0 0 -1 -1  0 0 0 -1");
  const Lists<HalfedgeId> order = edge_slope_ordering(g);
  const auto center = std::find(g.vertices.begin(), g.vertices.end(), PointD{0, 0});
  std::string text;
  for (HalfedgeId h : order[static_cast<std::size_t>(center - g.vertices.begin())]) {
    const Edge& e = g.edges[edge_of(h)];
    const PointD& p = g.vertices[is_reversed(h) ? e.tail : e.head];
    text += std::to_string(int(p.x)) + ',' + std::to_string(int(p.y)) + ' ';
  }
  CHECK(text == "-1,-1 0,-1 1,0 1,1 0,1 -1,0 ");
}

TEST_CASE("the face walk uses each halfedge once and has the areas of the drawing") {
  const Graph g = split_graph("0 0 4 0  4 0 4 4  4 4 0 4  0 4 0 0  0 1 4 1  1 1 1 9");
  const Lists<HalfedgeId> order = edge_slope_ordering(g);
  const Lists<HalfedgeId> cycles = face_cycles(g, order);
  std::set<HalfedgeId> used(cycles.flat().begin(), cycles.flat().end());
  CHECK(used.size() == 2 * g.edges.size());
  CHECK(cycles.flat().size() == used.size());
  std::vector<double> areas = cycle_areas(g, cycles);
  const std::vector<Exterior> exteriors = exterior_cycles(g, order, cycles);
  REQUIRE(exteriors.size() == 1);
  CHECK(areas[exteriors[0].cycle] == -16);
  std::sort(areas.begin(), areas.end());
  CHECK(areas == std::vector<double>{-16, 3, 4, 9});
}

TEST_CASE("each component has one exterior cycle, trees too") {
  const Graph g = split_graph("0 0 1 0  1 0 2 1  1 0 2 -1  5 0 6 0  6 0 5 1  5 1 5 0");
  const Lists<HalfedgeId> order = edge_slope_ordering(g);
  const Lists<HalfedgeId> cycles = face_cycles(g, order);
  CHECK(cycles.size() == 3);
  CHECK(exterior_cycles(g, order, cycles).size() == 2);
}

TEST_CASE(
    "P1: a point is in the diamond |x| + |y| = 2 by that formula, on its corners' levels too") {
  const std::vector<PointD> diamond{{2, 0}, {0, 2}, {-2, 0}, {0, -2}};
  std::vector<PointD> points;
  for (int i = -5; i <= 5; ++i) {
    for (int j = -5; j <= 5; ++j) points.push_back({i / 2.0, j / 2.0});
  }
  const std::vector<Position> found = classify_points(diamond, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double norm = std::abs(points[i].x) + std::abs(points[i].y);
    INFO(points[i].x << ' ' << points[i].y);
    CHECK(found[i] == (norm < 2 ? Position::In : norm > 2 ? Position::Out : Position::On));
  }
}

TEST_CASE("P2: edges that end on the half-line count by the side that they come from") {
  // A comb whose teeth end, pass and run along the height of the query.
  const std::vector<PointD> comb{{0, -2}, {9, -2}, {9, 0}, {8, 0}, {8, 2}, {7, 2},  {7, 0}, {6, 0},
                                 {6, -1}, {5, -1}, {5, 0}, {4, 2}, {3, 0}, {2, -1}, {1, 0}, {0, 0}};
  const auto at = [&](double x, double y) { return classify_points(comb, {{{x, y}}})[0]; };
  CHECK(at(0.5, 0) == Position::On);
  CHECK(at(2, 0) == Position::Out);
  CHECK(at(4, 0) == Position::In);
  CHECK(at(5.5, 0) == Position::Out);
  CHECK(at(6.5, 0) == Position::On);
  CHECK(at(7.5, 0) == Position::In);
  CHECK(at(8.5, 0) == Position::On);
  CHECK(at(-1, 0) == Position::Out);
  CHECK(at(-1, -2) == Position::Out);
  CHECK(at(0.5, -1) == Position::In);
}

TEST_CASE("an edge that a polygon runs along twice does not change the inside") {
  const std::vector<PointD> spiked{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {4, 2}, {4, 4}, {0, 4}};
  CHECK(classify_points(spiked, {{{1, 2}}})[0] == Position::In);
  CHECK(classify_points(spiked, {{{3, 1}}})[0] == Position::In);
  CHECK(classify_points(spiked, {{{3, 2}}})[0] == Position::On);
  CHECK(classify_points(spiked, {{{5, 2}}})[0] == Position::Out);
}

TEST_CASE("the innermost cycle is the smallest of those around a vertex") {
  const Graph g = split_graph(rectangle(0, 0, 9, 9) + rectangle(1, 1, 8, 8) +
                              rectangle(2, 2, 4, 4) + rectangle(5, 5, 6, 6) + "+ 3 3 + 7 7 + 20 5");
  const Lists<HalfedgeId> order = edge_slope_ordering(g);
  const Lists<HalfedgeId> cycles = face_cycles(g, order);
  const std::vector<double> areas = cycle_areas(g, cycles);
  std::vector<CycleId> outer;
  for (std::size_t c = 0; c < areas.size(); ++c) {
    if (areas[c] > 0) outer.push_back(CycleId(c));
  }
  std::vector<VertexId> points;
  for (const PointD& p : {PointD{3, 3}, {7, 7}, {20, 5}, {5, 5}, {0, 0}}) {
    points.push_back(
        VertexId(std::lower_bound(g.vertices.begin(), g.vertices.end(), p) - g.vertices.begin()));
  }
  std::vector<double> found;
  for (CycleId c : innermost_cycles(g, cycles, areas, outer, points)) {
    found.push_back(c.valid() ? areas[c] : 0);
  }
  CHECK(found == std::vector<double>{4, 49, 0, 49, 0});
}

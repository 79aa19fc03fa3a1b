// LAR models: makers, incidences, boundaries, what they draw. Expected values are those of the
// recorded outputs of the original larcc (cases larCuboids, cubes-2x2x2-boundary, larEmbed, test09,
// test10) or follow from counting.

#include "plumbline/structure/model.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <set>

#include "plumbline/chains.hpp"
#include "plumbline/error.hpp"

using plumbline::boundary_cells;
using plumbline::boundary_model;
using plumbline::boundary_polylines;
using plumbline::Cells;
using plumbline::cuboids;
using plumbline::edges;
using plumbline::embed;
using plumbline::lar_model;
using plumbline::LarModel;
using plumbline::Rational;

namespace {

std::string text(const Cells& cells) {
  std::string result;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    result += result.empty() ? "" : " ";
    for (const auto v : cells[c]) result += (v == cells[c].front() ? "" : ",") + std::to_string(v);
  }
  return result;
}

std::string vertices(const LarModel& model) {
  std::string result;
  for (std::size_t v = 0; v < model.vertex_count(); ++v) {
    result += result.empty() ? "" : " ";
    for (std::size_t i = 0; i < model.dimension; ++i) {
      result += (i == 0 ? "" : ",") + plumbline::exact_text(model.vertex(v)[i].rational());
    }
  }
  return result;
}

Cells cells(std::initializer_list<std::vector<std::uint32_t>> lists) {
  Cells result;
  for (const auto& list : lists) result.push_back(list);
  return result;
}

std::string drawn(const LarModel& model) {
  std::string result;
  const auto found = edges(model);
  for (const auto& [tail, head] : found.edges) {
    result += std::to_string(tail) + "-" + std::to_string(head) + " ";
  }
  for (const auto& [cell, reason] : found.refused) {
    result += "refused " + std::to_string(cell) + ": " + reason + " ";
  }
  return result;
}

std::uint64_t binomial(std::uint64_t n, std::uint64_t k) {
  return k == 0 ? 1 : binomial(n - 1, k - 1) * n / k;
}

}  // namespace

TEST_CASE("grids of cubes have the original's vertices and cells") {
  CHECK(vertices(cuboids({1, 1})) == "0,0 0,1 1,0 1,1");
  CHECK(text(cuboids({1, 1}).cells[0]) == "0,1,2,3");
  CHECK(vertices(cuboids({2, 1})) == "0,0 0,1 1,0 1,1 2,0 2,1");
  CHECK(text(cuboids({2, 1}).cells[0]) == "0,1,2,3 2,3,4,5");
  const LarModel full = cuboids({2, 2}, true);
  REQUIRE(full.cells.size() == 3);
  CHECK(text(full.cells[0]) == "0,1,3,4 1,2,4,5 3,4,6,7 4,5,7,8");
  CHECK(text(full.cells[1]) == "0,1 1,2 3,4 4,5 6,7 7,8 0,3 1,4 2,5 3,6 4,7 5,8");
  CHECK(text(full.cells[2]) == "0 1 2 3 4 5 6 7 8");
  const LarModel space = cuboids({2, 2, 2}, true);
  CHECK(text(space.cells[0]).substr(0, 42) == "0,1,3,4,9,10,12,13 1,2,4,5,10,11,13,14 3,4");
  CHECK(text(space.cells[1]).substr(0, 24) == "0,1,3,4 1,2,4,5 3,4,6,7 ");
  CHECK(text(boundary_model(space).cells[0]).substr(0, 24) == "0,1,3,4 1,2,4,5 3,4,6,7 ");
}

TEST_CASE("the boundary of the 2 x 2 x 2 cubes is the recorded one") {
  CHECK(boundary_cells(cuboids({2, 2, 2}, true)) ==
        std::vector<std::uint32_t>{0,  1,  2,  3,  8,  9,  10, 11, 12, 13, 16, 17,
                                   18, 19, 22, 23, 24, 26, 27, 29, 30, 32, 33, 35});
}

TEST_CASE("the boundary of the 10 x 10 x 10 cubes has 600 squares") {
  const LarModel boundary = boundary_model(cuboids({10, 10, 10}, true));
  CHECK(boundary.cells[0].size() == 600);
  CHECK(boundary.vertex_count() == 1331);
  const auto flat = boundary.cells[0].flat();
  CHECK(std::accumulate(flat.begin(), flat.end(), 0UL) == 1596000);  // as recorded
}

TEST_CASE("a cube has C(d, k) 2^(d-k) faces of dimension k, and a boundary without boundary") {
  for (std::size_t d = 1; d <= 6; ++d) {
    const LarModel cube = cuboids(std::vector<std::uint32_t>(d, 1), true);
    for (std::size_t k = 0; k <= d; ++k) {
      CHECK(cube.cells[d - k].size() == binomial(d, k) << (d - k));
    }
    if (d < 2) continue;
    CHECK(boundary_cells(cube).size() == 2 * d);
    const LarModel boundary{
        {}, d, cube.coordinates, {boundary_model(cube).cells[0], cube.cells[2]}};
    CHECK(boundary_cells(boundary).empty());
  }
}

TEST_CASE("the composition of two boundary operators is zero mod 2") {
  const LarModel grid = cuboids({3, 2, 2}, true);
  for (std::size_t k = 0; k + 2 < grid.cells.size(); ++k) {
    const plumbline::ChainMatrix upper = boundary_mod_2(grid, k);
    const plumbline::ChainMatrix lower = boundary_mod_2(grid, k + 1);
    REQUIRE(upper.cols() == static_cast<Eigen::Index>(grid.cells[k].size()));
    CHECK(upper.sum() == static_cast<int>(upper.cols() * 2 * static_cast<long>(3 - k)));
    const plumbline::ChainMatrix composed = lower * upper;
    for (int c = 0; c < composed.outerSize(); ++c) {
      for (plumbline::ChainMatrix::InnerIterator entry(composed, c); entry; ++entry) {
        CHECK(entry.value() % 2 == 0);
      }
    }
  }
}

TEST_CASE("grids that are empty, flat or too large are told apart") {
  CHECK(vertices(cuboids({0, 1})) == "0,0 0,1");
  CHECK(cuboids({0, 1}).cells[0].size() == 0);
  CHECK(text(cuboids({0, 1}, true).cells[1]) == "0,1");
  CHECK_THROWS_AS(cuboids({}), plumbline::Error);
  CHECK_THROWS_AS(cuboids({1U << 31U, 1U << 31U}), plumbline::Error);
  CHECK_THROWS_AS(cuboids({0xffffffffU, 0}), plumbline::Error);
  CHECK_THROWS_AS(cuboids(std::vector<std::uint32_t>(25, 0)), plumbline::Error);
}

TEST_CASE("embedding adds zeros, projecting drops the last coordinates") {
  CHECK(vertices(embed(cuboids({1, 1}), 1)) == "0,0,0 0,1,0 1,0,0 1,1,0");
  CHECK(vertices(embed(cuboids({1, 1}), -1)) == "0 0 1 1");
  // The original keeps one coordinate of three here (L4 of the catalogue).
  CHECK(vertices(embed(cuboids({1, 1, 1}), -1)) == "0,0 0,0 0,1 0,1 1,0 1,0 1,1 1,1");
  CHECK(embed(cuboids({1, 1, 1}), -1).cells == cuboids({1, 1, 1}).cells);
  CHECK_THROWS_AS(embed(cuboids({1, 1}), -2), plumbline::Error);
}

TEST_CASE("a model is mapped vertex by vertex") {
  const LarModel moved = apply(plumbline::translation({1, 2, 3}), cuboids({1, 1, 1}));
  CHECK(vertices(moved) == "1,2,3 1,2,4 1,3,3 1,3,4 2,2,3 2,2,4 2,3,3 2,3,4");
  CHECK_THROWS_AS(apply(plumbline::translation(1, 2), cuboids({1})), plumbline::Error);
}

TEST_CASE("models that are not whole are refused") {
  CHECK_THROWS_AS(lar_model(2, {0, 0, 1}, {}), plumbline::Error);
  CHECK_THROWS_AS(lar_model(2, {0, 0, 1, 1}, {cells({{0, 2}})}), plumbline::Error);
  LarModel flat;
  flat.dimension = 0;
  CHECK_THROWS_AS(check(flat), plumbline::Error);
}

TEST_CASE("a model draws its last array, each edge once") {
  const LarModel grid = cuboids({1, 2}, true);
  const LarModel triple{{}, 2, grid.coordinates, {grid.cells[0], grid.cells[1]}};
  CHECK(drawn(triple) == "0-1 0-3 1-2 1-4 2-5 3-4 4-5 ");
  const LarModel pair{{}, 2, grid.coordinates, {grid.cells[0]}};
  CHECK(drawn(pair) == "0-1 0-3 1-2 1-4 2-5 3-4 4-5 ");  // convex hulls: no order given
  CHECK(drawn(lar_model(2, {0, 0, 1, 0}, {})).empty());
}

TEST_CASE("a cell without edges is the simple polygon of its order, or a convex hull") {
  // An L: not convex, in order.
  const std::vector<Rational> corners{0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2};
  CHECK(drawn(lar_model(2, corners, {cells({{0, 1, 2, 3, 4, 5}})})) == "0-1 0-5 1-2 2-3 3-4 4-5 ");
  // The same out of order: neither.
  CHECK(drawn(lar_model(2, corners, {cells({{0, 2, 1, 3, 4, 5}})})) ==
        "refused 0: a cell that is neither a simple polygon in its order nor convex ");
  // A square in lattice order with points amid its sides.
  const std::vector<Rational> square{0, 0, 0, 1, 0, 2, 1, 0, 1, 2, 2, 0, 2, 1, 2, 2};
  CHECK(drawn(lar_model(2, square, {cells({{0, 1, 2, 3, 4, 5, 6, 7}})})) ==
        "0-1 0-3 1-2 2-4 3-5 4-7 5-6 6-7 ");
  // Its diagonal is the line between the first point and the last.
  CHECK(drawn(lar_model(2, {0, 0, 0, 1, 1, 0, 1, 1}, {cells({{0, 1, 2, 3}})})) ==
        "0-1 0-2 1-3 2-3 ");
  // A triangle with a point amid the side from first to last, above and below.
  CHECK(drawn(lar_model(2, {0, 0, 1, 0, 2, 0, 1, 1}, {cells({{0, 2, 1, 3}})})) ==
        "0-1 0-3 1-2 2-3 ");
  CHECK(drawn(lar_model(2, {0, 0, 1, 0, 2, 0, 1, -1}, {cells({{0, 2, 1, 3}})})) ==
        "0-1 0-3 1-2 2-3 ");
}

TEST_CASE("cells that can't be drawn are refused one by one") {
  const std::vector<Rational> points{0, 0, 1, 0, 2, 0, 1, 1, 0, 0};
  CHECK(drawn(lar_model(2, points, {cells({{0, 1, 2}, {0}, {0, 1, 0}, {0, 4}, {1, 3}})})) ==
        "1-3 "
        "refused 0: a cell that is neither a simple polygon in its order nor convex "
        "refused 1: a cell of less than two vertices "
        "refused 2: a cell that has a vertex twice "
        "refused 3: a cell that has a vertex twice ");
  CHECK_THROWS_AS(edges(cuboids({1, 1, 1})), plumbline::Error);
}

TEST_CASE("a polygon whose sides touch is not simple") {
  const auto drawn_in_order = [](const std::vector<Rational>& corners) {
    std::vector<std::uint32_t> cell(corners.size() / 2);
    std::iota(cell.begin(), cell.end(), 0U);
    return drawn(lar_model(2, corners, {cells({cell})}));
  };
  const std::string neither =
      "refused 0: a cell that is neither a simple polygon in its order nor convex ";
  // A spike: the way back from (1, 3) passes (2, 2).
  CHECK(drawn_in_order({0, 0, 4, 0, 4, 4, 2, 2, 1, 3, 3, 1}) == neither);
  // The side from (2, 5) to (6, 3) touches the corner (4, 4).
  CHECK(drawn_in_order({0, 0, 8, 0, 8, 8, 4, 4, 0, 8, 2, 5, 6, 3}) == neither);
  // A bow tie: its corners are convex.
  CHECK(drawn_in_order({0, 0, 2, 2, 2, 0, 0, 2}) == "0-2 0-3 1-2 1-3 ");
}

TEST_CASE("boundary polylines close, and are split where they touch") {
  // Two unit squares that share a corner, of a 2 x 2 grid.
  const LarModel grid = cuboids({2, 2}, true);
  Cells two = cells({{0, 1, 3, 4}, {4, 5, 7, 8}});
  const LarModel model{{}, 2, grid.coordinates, {two, grid.cells[1]}};
  CHECK(text(boundary_polylines(model)) == "0,1,4,3 4,5,8,7");
  const LarModel whole{{}, 2, grid.coordinates, {grid.cells[0], grid.cells[1]}};
  CHECK(text(boundary_polylines(whole)) == "0,1,2,5,8,7,6,3");
  // A ring of eight squares: its outer boundary, then its hole.
  const LarModel nine = cuboids({3, 3}, true);
  Cells ring;
  for (std::size_t c = 0; c < 9; ++c) {
    if (c != 4) ring.push_back(nine.cells[0][c]);
  }
  const LarModel annulus{{}, 2, nine.coordinates, {ring, nine.cells[1]}};
  CHECK(text(boundary_polylines(annulus)) == "0,1,2,3,7,11,15,14,13,12,8,4 5,6,10,9");
  const LarModel torn{{}, 2, grid.coordinates, {grid.cells[0], cells({{0, 1}})}};
  CHECK_THROWS_AS(boundary_polylines(torn), plumbline::Error);
}

TEST_CASE("a fan of triangles covers a polygon, a cone of triangles makes tetrahedra") {
  const Cells sides = cells({{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}});
  CHECK(text(simplicial_fan(sides, 0)) == "0,1,2 0,2,3 0,3,4");
  CHECK(text(simplicial_fan(cells({{0, 1, 2}}), 3)) == "3,0,1,2");
}

TEST_CASE("the boundary of polygons is that of their sides, whatever their shape") {
  const LarModel grid = cuboids({3, 3});
  CHECK(polygon_boundary(grid).cells[0].size() == 12);
  // A U and what fills it: the U has both ends of the niche's opening, but not the side between.
  const std::vector<Rational> corners{0, 0, 3, 0, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3, 0, 3};
  const LarModel plan = lar_model(2, corners, {cells({{0, 1, 2, 3, 4, 5, 6, 7}, {5, 4, 3, 6}})});
  CHECK(text(polygon_boundary(plan).cells[0]) == "0,1 0,7 1,2 2,3 3,6 6,7");
  CHECK(text(boundary_polylines(polygon_boundary(plan))) == "0,1,2,3,6,7");
  CHECK_THROWS_AS(polygon_boundary(lar_model(2, corners, {cells({{0, 1}})})), plumbline::Error);
  CHECK_THROWS_AS(polygon_boundary(lar_model(2, corners, {cells({{0, 2, 1, 7, 5, 3}})})),
                  plumbline::Error);
}

TEST_CASE("a grid with all skeletons draws its edges, not its vertices") {
  CHECK(edges(cuboids({2, 1}, true)).edges.size() == 7);
  CHECK(edges(cuboids({2, 1}, true)).refused.empty());
}

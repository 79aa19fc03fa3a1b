// Simplification of LAR models (V, EV) and (V, FV, EV), in both variants.

#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/inters_vcode.hpp"

using namespace plumbline;

using lar::Model;

namespace {

Model model(std::vector<PointD> vertices, const std::vector<std::array<std::size_t, 2>>& edges,
            const std::vector<std::vector<std::size_t>>& faces) {
  Model result{std::move(vertices), {}, {}};
  for (const auto& [v, w] : edges) result.edges.push_back({VertexId(v), VertexId(w)});
  for (const auto& face : faces) {
    std::vector<VertexId> cell;
    for (const std::size_t v : face) cell.emplace_back(v);
    result.faces.push_back(cell);
  }
  return result;
}

using Cells = std::multiset<std::vector<std::size_t>>;

/// An edge of two equal vertices is one vertex.
Cells edges(const Model& m) {
  Cells result;
  for (const auto& [v, w] : m.edges) {
    result.insert(v == w ? std::vector<std::size_t>{v} : std::vector<std::size_t>{v, w});
  }
  return result;
}

Cells faces(const Model& m) {
  Cells result;
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    result.insert({m.faces[f].begin(), m.faces[f].end()});
  }
  return result;
}

/// Two triangles of a square, each with its own vertices along the diagonal; between them a sliver,
/// and a repeated triangle.
const Model kSquare = model({{0, 0}, {1, 0}, {0, 1}, {1.0004, 0}, {1, 1}, {0, 1.0004}},
                            {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {1, 3}, {2, 5}},
                            {{0, 1, 2}, {3, 4, 5}, {1, 3, 5, 2}, {2, 0, 1}});

}  // namespace

TEST_CASE("simplification joins triangles along their common side and drops what is thinner") {
  const Model m = lar::simplify(kSquare, 0.001);
  REQUIRE(m.vertices.size() == 4);
  CHECK(m.vertices[0] == PointD{0, 0});
  CHECK(m.vertices[1].y == Approx(1.0002));
  CHECK(m.vertices[2] == PointD{1, 1});
  CHECK(m.vertices[3].x == Approx(1.0002));
  CHECK(edges(m) == Cells{{0, 1}, {0, 3}, {1, 2}, {1, 3}, {2, 3}});
  CHECK(faces(m) == Cells{{0, 3, 1}, {3, 2, 1}});                   // vertices in their old order
  CHECK(m.vertices.size() - m.edges.size() + m.faces.size() == 1);  // Euler: a disk
}

TEST_CASE("simplification within less than the distance keeps all but repeated cells") {
  const Model m = lar::simplify(kSquare, 0.0003);
  CHECK(m.vertices.size() == 6);
  CHECK(m.edges.size() == 8);
  CHECK(m.faces.size() == 3);
  CHECK(lar::simplify(m, 0.0003) == m);
}

TEST_CASE("simplification drops vertices that no cell uses, also in models without faces") {
  const Model m = lar::simplify(
      model({{0, 0}, {5, 5}, {1, 0}, {1.0002, 0}, {9, 9}}, {{2, 0}, {0, 3}, {2, 3}}, {}), 0.001);
  REQUIRE(m.vertices.size() == 2);
  CHECK(m.vertices[1].x == Approx(1.0001));
  CHECK(edges(m) == Cells{{0, 1}});
  CHECK(lar::simplify(Model{}, 0.001) == Model{});
}

TEST_CASE("Q10: the published simplification of (V, FV, EV) keeps edges that became a point") {
  const Model m = inters::simplify(kSquare, 0.001);
  REQUIRE(m.vertices.size() == 4);  // by least members: (0,0), (1,0), (0,1), (1,1)
  CHECK(m.vertices[1].x == Approx(1.0002));
  CHECK(edges(m) == Cells{{0, 1}, {1, 2}, {0, 2}, {1, 3}, {2, 3}, {1}, {2}});
  CHECK(faces(m) == Cells{{0, 1, 2}, {1, 2, 3}});
}

TEST_CASE("the published simplification of (V, EV) drops them, and keeps unused vertices") {
  const Model m = inters::simplify(
      model({{0, 0}, {5, 5}, {1, 0}, {1.0002, 0}}, {{0, 2}, {3, 0}, {2, 3}}, {}), 0.001);
  CHECK(m.vertices.size() == 3);
  CHECK(edges(m) == Cells{{0, 2}});
}

TEST_CASE("the published simplification lists faces by their number of vertices") {
  const Model m = inters::simplify(
      model({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {4, 0}}, {{0, 1}}, {{0, 1, 2, 3}, {1, 4, 2}}));
  REQUIRE(m.faces.size() == 2);
  CHECK(m.faces[0].size() == 3);
  CHECK(m.faces[1].size() == 4);
}

TEST_CASE("fixed decimals are from 0 to 12, and half is rounded away from zero") {
  CHECK_THROWS_WITH(inters::Vcode(-1), Catch::Contains("from 0 to 12"));
  CHECK_THROWS_WITH(inters::Vcode(13), Catch::Contains("from 0 to 12"));
  CHECK(inters::Vcode(0).text(-2.5) == "-3.0");
  CHECK(inters::Vcode(12).text(0.5) == "0.5");
}

TEST_CASE("a bad radius or cell is refused by both simplifications") {
  const Model hole = model({{0, 0}, {1, 0}}, {{0, 2}}, {});
  CHECK_THROWS_WITH(lar::simplify(hole, 0.1), Catch::Contains("vertex that the model has not"));
  CHECK_THROWS_WITH(inters::simplify(hole), Catch::Contains("vertex that the model has not"));
  const Model empty_face = model({{0, 0}, {1, 0}}, {{0, 1}}, {{}});
  CHECK_THROWS_WITH(lar::simplify(empty_face, 0.1), Catch::Contains("no vertex"));
  CHECK_THROWS_WITH(inters::simplify(empty_face), Catch::Contains("no vertex"));
  CHECK_THROWS_WITH(inters::simplify(Model{}), Catch::Contains("needs an edge"));
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double radius : {-1.0, infinity}) {
    CHECK_THROWS_AS(lar::simplify(kSquare, radius), Error);
    CHECK_THROWS_AS(inters::simplify(kSquare, radius), Error);
  }
  CHECK_THROWS_AS(inters::simplify(kSquare, 0), Error);
}

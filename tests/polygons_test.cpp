// Complexes made of faces that others list.

#include "plumbline/engine/cell_lists.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "plumbline/arrange.hpp"
#include "plumbline/compare.hpp"
#include "plumbline/error.hpp"

using namespace plumbline;

namespace {

std::vector<VertexId> ring(std::initializer_list<std::size_t> vertices) {
  return {vertices.begin(), vertices.end()};
}

/// "face outer 0 1 2 | hole 3 4 5" in one line for each face.
std::string faces_text(const FloatComplex& c) {
  std::string text;
  const auto add = [&](const char* name, CycleId cycle) {
    text += name;
    for (const HalfedgeId h : c.cycles[cycle]) text += " " + std::to_string(c.origin(h));
  };
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    text += f == 0 ? "unbounded" : "face";
    if (c.face_outer[f].valid()) add(" outer", c.face_outer[f]);
    for (const CycleId hole : c.face_holes[f]) add(" | hole", hole);
    for (const VertexId v : c.face_isolated_vertices[f]) text += " | vertex " + std::to_string(v);
    text += "\n";
  }
  return text;
}

std::vector<Invariant> broken(const FloatComplex& complex) {
  std::vector<Invariant> result;
  for (const Violation& v : validate(exact(complex))) {
    if (result.empty() || result.back() != v.invariant) result.push_back(v.invariant);
  }
  return result;
}
bool is_broken(const FloatComplex& complex, Invariant invariant) {
  return std::ranges::count(broken(complex), invariant) > 0;
}

const std::vector<PointD> kNestedSquares = {{0, 0}, {9, 0}, {9, 9}, {0, 9},
                                            {3, 3}, {6, 3}, {6, 6}, {3, 6}};

/// Horizontal, vertical and diagonal segments of even coordinates: all crossings are integers.
SegmentSet random_grid_drawing(std::mt19937& random, int size) {
  std::uniform_int_distribution<int> place(0, size), length(1, size), direction(0, 3);
  constexpr std::array<std::array<int, 2>, 4> kDirections = {{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
  SegmentSet set;
  const SourceId source = set.add_source({});
  for (int i = 0; i < 2 * size; ++i) {
    const PointD a{2.0 * place(random), 2.0 * place(random)};
    const auto [dx, dy] = kDirections[static_cast<std::size_t>(direction(random))];
    const int l = length(random);
    set.add(a, PointD{a.x + 2 * l * dx, a.y + 2 * l * dy}, source);
  }
  return set;
}

FloatComplex without_sources(const ExactComplex& complex) {
  FloatComplex result = nearest(complex);
  result.edge_sources = {};
  for (std::size_t e = 0; e < result.edge_count(); ++e) {
    result.edge_sources.push_back(std::vector<SegmentId>());
  }
  return canonical(result);
}

/// Its cells as lists, rings turned and begun at random. Antennas are left out of the rings.
CellLists lists_of(const FloatComplex& c, std::mt19937& random) {
  CellLists cells;
  cells.vertices = c.vertices;
  for (const Edge& e : c.edges) cells.edges.push_back({e.tail, e.head});
  cells.lists_all_edges = true;
  const auto ring_of = [&](CycleId cycle) {
    std::vector<VertexId> result;
    for (const HalfedgeId h : c.cycles[cycle]) result.push_back(c.origin(h));
    std::rotate(result.begin(), result.begin() + random() % result.size(), result.end());
    if (random() % 2 == 0) std::reverse(result.begin(), result.end());
    if (random() % 2 == 0) result.push_back(result.front());
    return result;
  };
  const auto is_tree = [&](CycleId cycle) {
    return std::ranges::all_of(c.cycles[cycle], [&](HalfedgeId h) {
      return std::ranges::count(c.cycles[cycle], twin(h)) == 1;
    });
  };
  for (std::size_t f = 1; f < c.face_count(); ++f) {
    Polygon face{ring_of(c.face_outer[f])};
    for (const CycleId hole : c.face_holes[f]) {
      if (!is_tree(hole)) face.holes.push_back(ring_of(hole));
    }
    cells.faces.push_back(std::move(face));
  }
  std::shuffle(cells.faces.begin(), cells.faces.end(), random);
  return cells;
}

}  // namespace

TEST_CASE("polygons: a square with a hole and the square in it are two faces, turned either way") {
  const CellLists cells{
      kNestedSquares, {}, {{ring({3, 2, 1, 0}), {ring({4, 5, 6, 7, 4})}}, {ring({5, 6, 7, 4})}}};
  const FloatComplex c = complex_from_faces(cells);
  CHECK(broken(c).empty());
  // In canonical order, by (x, y): 0 (0,0), 1 (0,9), 2 (3,3), 3 (3,6), 4 (6,3), 5 (6,6), 6, 7.
  CHECK(faces_text(c) ==
        "unbounded | hole 0 1 7 6\n"
        "face outer 1 0 6 7 | hole 2 3 5 4\n"
        "face outer 3 2 4 5\n");
}

TEST_CASE("polygons: a hole that is not listed stays a cycle without face") {
  const CellLists cells{kNestedSquares, {}, {{ring({0, 1, 2, 3})}, {ring({4, 5, 6, 7})}}};
  const FloatComplex c = complex_from_faces(cells);
  CHECK(faces_text(c) == "unbounded | hole 0 1 7 6\nface outer 1 0 6 7\nface outer 3 2 4 5\n");
  CHECK(is_broken(c, Invariant::HalfedgeInCycle));
}

TEST_CASE("polygons: a gap is a cycle without face") {
  const CellLists cells{kNestedSquares, {}, {{ring({0, 1, 2, 3}), {ring({4, 5, 6, 7})}}}};
  const FloatComplex c = complex_from_faces(cells);
  CHECK(c.cycles.size() == 4);
  CHECK(std::ranges::count(c.cycle_face, FaceId()) == 1);
  CHECK(is_broken(c, Invariant::HalfedgeInCycle));
}

TEST_CASE("polygons: faces that overlap both keep the halfedges that they share") {
  const std::vector<PointD> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 6}};
  const CellLists cells{points, {}, {{ring({0, 1, 2, 3})}, {ring({0, 1, 2, 4, 3})}}};
  const FloatComplex c = complex_from_faces(cells);
  CHECK(c.face_count() == 3);
  const std::vector<Violation> violations = validate(exact(c));
  const auto overlap = std::ranges::find(
      violations, "3 halfedges are in 2 cycles of faces, not in one", &Violation::message);
  REQUIRE(overlap != violations.end());
  CHECK(overlap->invariant == Invariant::HalfedgeInCycle);
  CHECK(overlap->faces == std::vector{FaceId(1), FaceId(2)});
}

TEST_CASE("polygons: repeated vertices, repeated edges and crossing edges stay") {
  SECTION("vertices") {
    const CellLists cells{{{0, 0}, {1, 0}, {0, 1}, {0, 0}}, {}, {{ring({0, 1, 2})}}};
    CHECK(is_broken(complex_from_faces(cells), Invariant::DuplicateVertex));
  }
  SECTION("edges") {
    const CellLists cells{{{0, 0}, {1, 0}, {0, 1}},
                          {{VertexId(0), VertexId(1)}, {VertexId(1), VertexId(0)}},
                          {{ring({0, 1, 2})}}};
    const FloatComplex c = complex_from_faces(cells);
    CHECK(c.edge_count() == 4);
    CHECK(is_broken(c, Invariant::DuplicateEdge));
  }
  SECTION("crossing edges") {
    const CellLists cells{{{0, 0}, {2, 2}, {0, 2}, {2, 0}}, {}, {{ring({0, 1, 2, 3})}}};
    CHECK(is_broken(complex_from_faces(cells), Invariant::Crossing));
  }
}

TEST_CASE("polygons: where all edges are listed, a side that is none makes its cycle jump") {
  const CellLists cells{{{0, 0}, {1, 0}, {0, 1}},
                        {{VertexId(0), VertexId(1)}, {VertexId(1), VertexId(2)}},
                        {{ring({0, 1, 2})}},
                        true};
  CHECK(is_broken(complex_from_faces(cells), Invariant::CycleClosed));
}

TEST_CASE("polygons: edges and vertices inside a face become its antennas, holes and vertices") {
  std::vector<PointD> points = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {1, 1}, {2, 2}, {3, 1}, {5, 5}};
  const CellLists cells{
      points, {{VertexId(0), VertexId(4)}, {VertexId(5), VertexId(6)}}, {{ring({0, 1, 2, 3})}}};
  const FloatComplex c = complex_from_faces(cells);
  CHECK(broken(c).empty());
  // 0 (0,0), 1 (0,9), 2 (1,1), 3 (2,2), 4 (3,1), 5 (5,5), 6 (9,0), 7 (9,9)
  CHECK(faces_text(c) ==
        "unbounded | hole 0 1 7 6\n"
        "face outer 1 0 2 0 6 7 | hole 3 4 | vertex 5\n");
}

TEST_CASE("polygons: a hole that touches the outer boundary in a vertex is part of it") {
  const std::vector<PointD> points = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {3, 1}, {1, 3}};
  const CellLists cells{points, {}, {{ring({0, 1, 2, 3}), {ring({0, 4, 5})}}, {ring({0, 4, 5})}}};
  const FloatComplex c = complex_from_faces(cells);
  CHECK(broken(c).empty());
  CHECK(c.face_count() == 3);
  CHECK(c.cycles.size() == 3);
}

TEST_CASE("polygons: a vertex that is not there is an error") {
  const CellLists cells{{{0, 0}, {1, 0}, {0, 1}}, {}, {{ring({0, 1, 3})}}};
  CHECK_THROWS_AS(complex_from_faces(cells), Error);
}

TEST_CASE("polygons: the lists of an arrangement give its complex back") {
  std::mt19937 random(6);
  for (int i = 0; i < 300; ++i) {
    const FloatComplex expected = without_sources(arrange(random_grid_drawing(random, 1 + i % 7)));
    CHECK(complex_from_faces(lists_of(expected, random)) == expected);
  }
}

TEST_CASE("polygons: lists of anything at all can be validated and comparisoned") {
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return random() % n; };
  for (int i = 0; i < 2000; ++i) {
    CellLists cells;
    const std::size_t vertices = 1 + below(12), side = 1 + below(5);
    for (std::size_t v = 0; v < vertices; ++v) {
      cells.vertices.push_back({double(below(side)), double(below(side))});
    }
    const auto vertex = [&] { return VertexId(below(vertices)); };
    for (std::size_t e = below(20); e > 0; --e) cells.edges.push_back({vertex(), vertex()});
    const auto random_ring = [&] {
      std::vector<VertexId> result;
      for (std::size_t k = below(7); k > 0; --k) result.push_back(vertex());
      return result;
    };
    for (std::size_t f = below(6); f > 0; --f) {
      cells.faces.push_back({random_ring()});
      for (std::size_t k = below(3); k > 0; --k) cells.faces.back().holes.push_back(random_ring());
    }
    cells.lists_all_edges = below(2) == 0;
    const FloatComplex garbage = complex_from_faces(cells);
    const ExactComplex drawing = arrange(random_grid_drawing(random, 3));
    const Comparison result = compare(drawing, garbage, 0.5);
    CHECK(result.float_valid == validate(exact(garbage)).empty());
  }
}

// Arrangement, the implicit result, against the canonical complex and the reference engine.

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

#include "inputs/families.hpp"
#include "inputs/hostile.hpp"
#include "plumbline/arrange.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

std::string counts(const Arrangement& a) {
  return std::to_string(a.vertex_count()) + " " + std::to_string(a.edge_count()) + " " +
         std::to_string(a.face_count()) + " " + std::to_string(a.component_count());
}

/// Canonical vertex of each vertex, by its exact point.
std::vector<VertexId> canonical_vertices(const Arrangement& a, const ExactComplex& complex) {
  std::vector<VertexId> result;
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    result.emplace_back(complex.vertices.count_before(a.point(VertexId(v))));
  }
  return result;
}

}  // namespace

TEST_CASE("an arrangement tells the same as its canonical complex") {
  const std::string family = GENERATE(from_range(inputs::families()));
  CAPTURE(family);
  const SegmentSet input = inputs::of_family(family, 3);
  const Arrangement a(input);
  const ExactComplex complex = a.complex();
  CHECK(counts(a) ==
        std::to_string(complex.vertices.size()) + " " + std::to_string(complex.edge_count()) + " " +
            std::to_string(complex.face_count()) + " " + std::to_string(complex.component_count()));
  const std::vector<VertexId> vertex = canonical_vertices(a, complex);
  std::vector<bool> met(vertex.size(), false);
  for (std::size_t v = 0; v < vertex.size(); ++v) {
    REQUIRE(complex.vertices.at(vertex[v]) == a.point(VertexId(v)));
    CHECK(a.nearest(VertexId(v)) == nearest(complex.vertices[vertex[v]]));
    met[vertex[v]] = true;
  }
  CHECK(std::find(met.begin(), met.end(), false) == met.end());

  std::map<std::pair<VertexId, VertexId>, EdgeId> edges;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    edges[{complex.edges[e].tail, complex.edges[e].head}] = EdgeId(e);
  }
  std::map<FaceId, FaceId> faces;
  for (std::size_t h = 0; h < 2 * a.edge_count(); ++h) {
    const HalfedgeId id(h);
    const Edge edge = a.edge(edge_of(id));
    const EdgeId e = edges.at({vertex[edge.tail], vertex[edge.head]});  // the tail first
    const auto sources = complex.edge_sources[e];
    CHECK(a.sources(edge_of(id)) == std::vector<SegmentId>(sources.begin(), sources.end()));
    // The next halfedge starts where this one ends, on the same cycle.
    const HalfedgeId next = a.next(id);
    const Edge next_edge = a.edge(edge_of(next));
    CHECK((is_reversed(id) ? edge.tail : edge.head) ==
          (is_reversed(next) ? next_edge.head : next_edge.tail));
    CHECK(a.cycle(next) == a.cycle(id));
    // One face here is one face there.
    const FaceId face = complex.halfedge_face[halfedge(e, is_reversed(id))];
    CHECK(faces.emplace(a.face(a.cycle(id)), face).first->second == face);
  }
  std::size_t holes = 0, isolated = 0;
  for (std::size_t f = 0; f < a.face_count(); ++f) {
    CHECK(a.outer_boundary(FaceId(f)).valid() == (f != 0));
    for (const CycleId c : a.holes(FaceId(f))) CHECK(a.face(c) == FaceId(f));
    holes += a.holes(FaceId(f)).size();
    isolated += a.isolated_vertices(FaceId(f)).size();
  }
  CHECK(holes + isolated == a.component_count());
}

TEST_CASE("on inputs made to hurt, both engines return the same complex") {
  for (const inputs::Hostile& hostile : inputs::hostile()) {
    const SegmentSet input = hostile.make(40);
    if (input.segments.size() > 4000) continue;  // the reference is cubic in overlaps
    CAPTURE(hostile.name, input.segments.size());
    CHECK(arrange(input, ExactEngine::Bucket) == arrange(input, ExactEngine::Cgal));
  }
}

TEST_CASE("a few segments far away do not hide what is near") {
  // The grid is made for the hundred small segments; the others leave it on every side.
  SegmentSet input = segments(
      "-1000000 -999999 1000000 1000001  50 50 51 1000000  -900000 3 900000 4  "
      "7 -800000 8 800000  1000000 1000000 1000001 1000000  -1000000 1 -999999 1");
  const SourceId source = input.add_source({});
  for (int i = 0; i < 100; ++i) {
    const int x = i * 37 % 100, y = i * 61 % 100;
    input.add({{x, y}, {x + 7, y + i % 13 - 6}}, source);
  }
  CHECK(arrange(input, ExactEngine::Bucket) == arrange(input, ExactEngine::Cgal));
}

TEST_CASE("bundles of parallel lines in every direction, crossed by a few") {
  for (const auto& [dx, dy] : {std::pair(40, 1), std::pair(40, 39), std::pair(1, 40),
                               std::pair(-39, 40), std::pair(-40, 1), std::pair(0, 40)}) {
    SegmentSet input;
    const SourceId source = input.add_source({});
    for (int i = 0; i < 120; ++i) {
      // Along (dx, dy), shifted across by a third of a unit each.
      const Rational shift = Rational(i) / 120;
      const Point a{-dy * shift, dx * shift};
      input.add({a, {a.x + dx, a.y + dy}}, source);
      if (i % 30 == 0) input.add({{a.x + dx / 2, -50}, {a.x + 3, 50}}, source);
    }
    CAPTURE(dx, dy);
    CHECK(arrange(input, ExactEngine::Bucket) == arrange(input, ExactEngine::Cgal));
  }
}

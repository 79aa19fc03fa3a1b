// A complex with faces joined, and what can be made of a set of faces.

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/union_find.hpp"
#include "plumbline/error.hpp"
#include "plumbline/regions.hpp"

namespace plumbline {
namespace {

/// Leaves out edges within classes, and makes the faces between the others.
class Joining {
 public:
  Joining(const ExactComplex& complex, std::span<const std::uint32_t> face_class)
      : complex_(complex), sets_(complex.face_count()), edge_(complex.edge_count()) {
    ensure(face_class.size() == complex.face_count(), "each face has a class");
    for (std::size_t e = 0; e < complex.edge_count(); ++e) {
      const FaceId left = side(e, false), right = side(e, true);
      if (face_class[left] == face_class[right]) {
        sets_.unite(left, right);
      } else {
        edge_[e] = EdgeId(kept_++);
      }
    }
  }

  JoinedComplex run() {
    JoinedComplex result;
    add_vertices_and_edges(result);
    add_faces(result.complex, cycles(result.complex));
    result.complex = canonical(std::move(result.complex));
    result.face_of = faces_of(result.complex);
    return result;
  }

 private:
  FaceId side(std::size_t e, bool reversed) const {
    return complex_.halfedge_face[halfedge(EdgeId(e), reversed)];
  }

  void add_vertices_and_edges(JoinedComplex& result) {
    std::vector<VertexId> number(complex_.vertices.size());
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      if (!edge_[e].valid()) continue;
      number[complex_.edges[e].tail] = number[complex_.edges[e].head] = VertexId(0);
    }
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (!number[v].valid()) continue;
      number[v] = VertexId(result.vertex_from.size());
      result.vertex_from.emplace_back(v);
      result.complex.vertices.push_back(complex_.vertices, v);
    }
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      if (!edge_[e].valid()) continue;
      const Edge& edge = complex_.edges[e];
      result.complex.edges.push_back({number[edge.tail], number[edge.head]});
      result.complex.edge_sources.push_back(complex_.edge_sources[e]);
    }
  }

  /// The cycles of the edges that are left, each with the face that it was found at. Around a
  /// vertex the next edge is that which follows past those that are gone.
  std::vector<FaceId> cycles(ExactComplex& into) const {
    std::vector<HalfedgeId> next(2 * complex_.edge_count());
    for (std::size_t c = 0; c < complex_.cycles.size(); ++c) {
      const auto cycle = complex_.cycles[c];
      for (std::size_t i = 0; i < cycle.size(); ++i) {
        next[cycle[i]] = cycle[i + 1 == cycle.size() ? 0 : i + 1];
      }
    }
    std::vector<FaceId> faces;
    std::vector<bool> is_done(next.size());
    std::vector<HalfedgeId> cycle;
    for (std::size_t first = 0; first < next.size(); ++first) {
      if (is_done[first] || !edge_[edge_of(HalfedgeId(first))].valid()) continue;
      cycle.clear();
      for (HalfedgeId h(first); !is_done[h];) {
        is_done[h] = true;
        cycle.push_back(halfedge(edge_[edge_of(h)], is_reversed(h)));
        h = next[h];
        while (!edge_[edge_of(h)].valid()) h = next[twin(h)];
      }
      into.cycles.push_back(cycle);
      faces.emplace_back(complex_.halfedge_face[first]);
    }
    return faces;
  }

  /// Of the cycles of a face the one with the least vertex is the outer one: no other goes through
  /// it, for one connected part of a boundary has one cycle.
  void add_faces(ExactComplex& into, const std::vector<FaceId>& found_at) {
    std::vector<FaceId> number(complex_.face_count());
    const std::size_t unbounded = sets_.find(kUnbounded);
    number[unbounded] = kUnbounded;
    std::vector<std::vector<CycleId>> holes(1);
    std::vector<VertexId> least{VertexId()};
    into.face_outer = {CycleId()};
    for (std::size_t c = 0; c < found_at.size(); ++c) {
      const std::size_t root = sets_.find(found_at[c]);
      VertexId of_cycle;
      for (const HalfedgeId h : into.cycles[c]) of_cycle = std::min(of_cycle, into.origin(h));
      if (!number[root].valid()) {
        number[root] = FaceId(into.face_outer.size());
        into.face_outer.emplace_back(c);
        least.push_back(of_cycle);
        holes.emplace_back();
        continue;
      }
      const FaceId face = number[root];
      CycleId hole(c);
      if (face != kUnbounded && of_cycle < least[face]) {
        std::swap(hole, into.face_outer[face]);
        least[face] = of_cycle;
      }
      holes[face].push_back(hole);
    }
    for (const auto& of : holes) {
      into.face_holes.push_back(of);
      into.face_isolated_vertices.push_back(std::vector<VertexId>());
    }
  }

  /// Told from the edges, which kept their order.
  std::vector<FaceId> faces_of(const ExactComplex& joined) {
    std::vector<FaceId> of_root(complex_.face_count());
    of_root[sets_.find(kUnbounded)] = kUnbounded;
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      if (!edge_[e].valid()) continue;
      for (const bool reversed : {false, true}) {
        of_root[sets_.find(side(e, reversed))] = joined.halfedge_face[halfedge(edge_[e], reversed)];
      }
    }
    std::vector<FaceId> result;
    for (std::size_t f = 0; f < complex_.face_count(); ++f) {
      result.push_back(of_root[sets_.find(f)]);
    }
    return result;
  }

  const ExactComplex& complex_;
  UnionFind sets_;
  std::vector<EdgeId> edge_;  ///< per edge its number among those left
  std::size_t kept_ = 0;
};

}  // namespace

JoinedComplex joined(const ExactComplex& complex, std::span<const std::uint32_t> face_class) {
  return Joining(complex, face_class).run();
}

RegionPolygons region_polygons(const ExactComplex& complex, const FaceSet& faces) {
  const std::vector<std::uint32_t> classes(faces.begin(), faces.end());
  JoinedComplex made = joined(complex, classes);
  FaceSet is_chosen(made.complex.face_count());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f]) is_chosen[made.face_of[f]] = true;
  }
  ensure(!is_chosen[kUnbounded], "a set of faces without the unbounded one");
  const std::vector<Rational> areas = face_areas(made.complex);
  RegionPolygons result;
  for (FacePolygon& polygon : polygons(made.complex)) {
    if (!is_chosen[polygon.face]) continue;
    result.areas.push_back(areas[polygon.face]);
    result.polygons.push_back(std::move(polygon));
  }
  result.complex = std::move(made.complex);
  return result;
}

std::vector<std::int8_t> boundary(const Incidences& complex, const FaceSet& faces) {
  std::vector<std::int8_t> result(complex.edge_count());
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const bool left = faces[complex.halfedge_face[halfedge(EdgeId(e), false)]];
    const bool right = faces[complex.halfedge_face[halfedge(EdgeId(e), true)]];
    result[e] = static_cast<std::int8_t>(int{left} - int{right});
  }
  return result;
}

Rational area(const ExactComplex& complex, const FaceSet& faces) {
  const std::vector<Rational> areas = face_areas(complex);
  Rational sum = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f]) sum += areas[f];
  }
  return sum;
}

}  // namespace plumbline

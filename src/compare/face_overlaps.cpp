// Sums up what runs around the area that an exact and a float face have in common.

#include "compare/face_overlaps.hpp"

#include <algorithm>
#include <map>

#include "compare/courses.hpp"
#include "compare/locate_faces.hpp"
#include "geometry/union_find.hpp"
#include "plumbline/error.hpp"

namespace plumbline::compare_steps {
namespace {

using Faces = Both<std::vector<std::size_t>>;

Rational cross(const Point& p, const Point& q) { return p.x * q.y - q.x * p.y; }

class OverlapSums {
 public:
  OverlapSums(const Sides& sides, const Faces& faces)
      : sides_(sides),
        edges_{edges_around(Exact, faces), edges_around(Float, faces)},
        points_(sides),
        contacts_(contacts(sides, points_, edges_)),
        courses_(sides, points_, contacts_) {
    for (const Side side : kBothSides) {
      is_asked_[side].resize(sides[side].face_count());
      for (const std::size_t f : faces[side]) is_asked_[side][f] = true;
    }
  }

  std::vector<Region> regions(const Faces& faces) && {
    for (const Side side : kBothSides) {
      const std::vector<FaceId> around_free = faces_around_free_edges(side);
      for (std::size_t i = 0; i < edges_[side].size(); ++i)
        for (Piece& piece : courses_.pieces(side, edges_[side][i])) {
          if (courses_.is_free(side, edges_[side][i])) piece.course.face = around_free[i];
          add_piece(side, edges_[side][i], piece);
        }
    }
    std::vector<Region> result;
    Both<std::map<std::size_t, Rational>> rest;
    for (const Side side : kBothSides)
      for (const std::size_t f : faces[side]) rest[side][f] = twice_area(side, FaceId(f));
    for (const auto& [pair, twice] : twice_common_) {
      if (sgn(twice) == 0) continue;
      rest[Exact][pair.first] -= twice;
      rest[Float][pair.second] -= twice;
      add_region(result, twice, {{{pair.first}, {pair.second}}});
    }
    for (const auto& [f, twice] : rest[Exact]) add_region(result, twice, {{{f}, {}}});
    for (const auto& [g, twice] : rest[Float]) add_region(result, twice, {{{}, {g}}});
    return result;
  }

 private:
  std::vector<EdgeId> edges_around(Side side, const Faces& faces) const;
  std::vector<FaceId> faces_around_free_edges(Side side) const;
  void add_piece(Side side, EdgeId e, const Piece& piece);
  Rational twice_area(Side side, FaceId f) const;

  bool is_asked(Side side, FaceId f) const { return f.valid() && is_asked_[side][f]; }
  static void add_region(std::vector<Region>& regions, const Rational& twice, Faces faces) {
    ensure(sgn(twice) >= 0,
           "faces of valid complexes have no more in common than there is of them");
    if (sgn(twice) > 0) regions.push_back({twice / 2, std::move(faces)});
  }

  const Sides& sides_;
  const Both<std::vector<EdgeId>> edges_;
  const CommonPoints points_;
  const Contacts contacts_;
  const Courses courses_;
  Both<std::vector<bool>> is_asked_;
  std::map<std::pair<std::size_t, std::size_t>, Rational> twice_common_;
};

/// The edges between two faces of which at least one is asked for.
std::vector<EdgeId> OverlapSums::edges_around(Side side, const Faces& faces) const {
  const ExactComplex& complex = sides_[side];
  std::vector<EdgeId> result;
  const auto add = [&](CycleId cycle) {
    for (const HalfedgeId h : complex.cycles[cycle])
      if (!complex.is_antenna(edge_of(h))) result.push_back(edge_of(h));
  };
  for (const std::size_t f : faces[side]) {
    add(complex.face_outer[f]);
    for (const CycleId hole : complex.face_holes[f]) add(hole);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Per edge that meets nothing of the other side the face there around it. Connected edges have
/// the same one until they meet something; of what meets nothing a vertex is located.
std::vector<FaceId> OverlapSums::faces_around_free_edges(Side side) const {
  const std::vector<EdgeId>& edges = edges_[side];
  const ExactComplex& complex = sides_[side];
  UnionFind sets(complex.vertices.size());
  for (const EdgeId e : edges)
    if (courses_.is_free(side, e)) sets.unite(complex.edges[e].tail, complex.edges[e].head);
  std::vector<FaceId> face_of(complex.vertices.size());  // per set
  for (const EdgeId e : edges) {
    if (courses_.is_free(side, e)) continue;
    for (const VertexId end : {complex.edges[e].tail, complex.edges[e].head}) {
      if (courses_.is_contact(side, e, end)) continue;
      const std::vector<Piece> pieces = courses_.pieces(side, e);
      const Piece& outer = end == complex.edges[e].tail ? pieces.front() : pieces.back();
      face_of[sets.find(end)] = outer.course.face;
    }
  }
  std::vector<std::size_t> unknown;
  for (const EdgeId e : edges) {
    const std::size_t set = sets.find(complex.edges[e].tail);
    if (courses_.is_free(side, e) && !face_of[set].valid()) unknown.push_back(set);
  }
  std::sort(unknown.begin(), unknown.end());
  unknown.erase(std::unique(unknown.begin(), unknown.end()), unknown.end());
  std::vector<Point> places;
  for (const std::size_t v : unknown) places.push_back(complex.vertices[v]);
  const std::vector<FaceId> located = locate_all(sides_[other(side)], places);
  for (std::size_t i = 0; i < unknown.size(); ++i) face_of[unknown[i]] = located[i];
  std::vector<FaceId> result;
  for (const EdgeId e : edges) result.push_back(face_of[sets.find(complex.edges[e].tail)]);
  return result;
}

/// What lies left of the piece gains, what lies right of it loses. What runs along an edge of the
/// other side counts once, for the exact side.
void OverlapSums::add_piece(Side side, EdgeId e, const Piece& piece) {
  const bool is_along = piece.course.along.valid();
  if (is_along && side == Float) return;
  std::optional<Rational> gain;
  for (const bool is_right : {false, true}) {
    const FaceId here = sides_[side].halfedge_face[halfedge(e, is_right)];
    FaceId there = piece.course.face;
    if (is_along && is_right) there = sides_[other(side)].halfedge_face[twin(piece.course.along)];
    if (!is_asked(side, here) || !is_asked(other(side), there)) continue;
    if (!gain) gain = cross(*piece.from, *piece.to);
    const auto pair = side == Exact ? std::pair<std::size_t, std::size_t>(here, there)
                                    : std::pair<std::size_t, std::size_t>(there, here);
    if (is_right)
      twice_common_[pair] -= *gain;
    else
      twice_common_[pair] += *gain;
  }
}

Rational OverlapSums::twice_area(Side side, FaceId f) const {
  const ExactComplex& complex = sides_[side];
  Rational twice = 0;
  const auto add = [&](CycleId cycle) {
    for (const HalfedgeId h : complex.cycles[cycle])
      if (!complex.is_antenna(edge_of(h)))
        twice += cross(complex.vertices[complex.origin(h)], complex.vertices[complex.target(h)]);
  };
  add(complex.face_outer[f]);
  for (const CycleId hole : complex.face_holes[f]) add(hole);
  return twice;
}

}  // namespace

std::vector<Region> face_overlaps(const Sides& sides, const Faces& faces) {
  return OverlapSums(sides, faces).regions(faces);
}

}  // namespace plumbline::compare_steps

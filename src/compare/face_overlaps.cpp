// Sums up what runs around the area that an exact and a float face have in common.

#include "compare/face_overlaps.hpp"

#include <algorithm>
#include <map>

#include "compare/courses.hpp"
#include "geometry/union_find.hpp"
#include "plumbline/error.hpp"

namespace plumbline::compare_steps {
namespace {

using Faces = Both<std::vector<std::size_t>>;

/// The sum of the terms, added in pairs: fractions without common denominators, added one after the
/// other, would make a number that is as long as all of them together at every step. Cost: that of
/// some multiplications of the final length.
Rational sum_of(std::vector<Rational> terms) {
  if (terms.empty()) return 0;
  for (std::size_t step = 1; step < terms.size(); step *= 2) {
    for (std::size_t i = 0; i + step < terms.size(); i += 2 * step) terms[i] += terms[i + step];
  }
  return terms.front();
}

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

  std::vector<Region> regions() && {
    for (const Side side : kBothSides) {
      const std::vector<FaceId> around_free = faces_around_free_edges(side);
      for (std::size_t i = 0; i < edges_[side].size(); ++i) {
        for (Piece& piece : courses_.pieces(side, edges_[side][i])) {
          if (courses_.is_free(side, edges_[side][i])) piece.course.face = around_free[i];
          add_piece(side, edges_[side][i], piece);
        }
      }
    }
    std::vector<Region> result;
    for (auto& [pair, terms] : twice_) {
      const Rational twice = sum_of(std::move(terms));
      ensure(sgn(twice) >= 0, "what faces of valid complexes have in common has no negative area");
      if (sgn(twice) == 0) continue;
      Region& region = result.emplace_back(Region{twice / 2, {}});
      if (pair.first != kNoFace) region.faces[Exact].push_back(pair.first);
      if (pair.second != kNoFace) region.faces[Float].push_back(pair.second);
    }
    return result;
  }

 private:
  std::vector<EdgeId> edges_around(Side side, const Faces& faces) const;
  std::vector<FaceId> faces_around_free_edges(Side side) const;
  void add_piece(Side side, EdgeId e, const Piece& piece);

  static constexpr std::size_t kNoFace = static_cast<std::size_t>(-1);
  std::size_t asked(Side side, FaceId f) const { return is_asked(side, f) ? f : kNoFace; }
  bool is_asked(Side side, FaceId f) const { return f.valid() && is_asked_[side][f]; }
  const Sides& sides_;
  const Both<std::vector<EdgeId>> edges_;
  const CommonPoints points_;
  const Contacts contacts_;
  const Courses courses_;
  Both<std::vector<bool>> is_asked_;
  /// By exact and float face; where there is none that is asked for, kNoFace.
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Rational>> twice_;  ///< to be added
};

/// The edges between two faces of which at least one is asked for.
std::vector<EdgeId> OverlapSums::edges_around(Side side, const Faces& faces) const {
  const ExactComplex& complex = sides_[side];
  std::vector<EdgeId> result;
  const auto add = [&](CycleId cycle) {
    for (const HalfedgeId h : complex.cycles[cycle]) {
      if (!complex.is_antenna(edge_of(h))) result.push_back(edge_of(h));
    }
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
  for (const EdgeId e : edges) {
    if (courses_.is_free(side, e)) sets.unite(complex.edges[e].tail, complex.edges[e].head);
  }
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
/// other side counts once, for the exact side if that edge is between faces asked for.
void OverlapSums::add_piece(Side side, EdgeId e, const Piece& piece) {
  const HalfedgeId along = piece.course.along;
  const bool is_along = along.valid();
  const auto is_asked_beside = [&](HalfedgeId h) {
    return is_asked(other(side), sides_[other(side)].halfedge_face[h]);
  };
  if (side == Float && is_along && (is_asked_beside(along) || is_asked_beside(twin(along)))) return;
  std::optional<Rational> gain;
  for (const bool is_right : {false, true}) {
    const FaceId here = sides_[side].halfedge_face[halfedge(e, is_right)];
    FaceId there = piece.course.face;
    if (is_along && is_right) there = sides_[other(side)].halfedge_face[twin(along)];
    if (!is_asked(side, here) && !is_asked(other(side), there)) continue;
    if (!gain) gain = cross(*piece.from, *piece.to);
    std::pair pair(asked(side, here), asked(other(side), there));
    if (side == Float) std::swap(pair.first, pair.second);
    twice_[pair].push_back(is_right ? Rational(-*gain) : *gain);
  }
}

}  // namespace

std::vector<Region> face_overlaps(const Sides& sides, const Faces& faces) {
  return OverlapSums(sides, faces).regions();
}

}  // namespace plumbline::compare_steps

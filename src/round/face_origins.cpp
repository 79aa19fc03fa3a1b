// Which exact face is each rounded face? The exact edges that became one rounded edge lie beside
// each other in a row. Between two of them is a face that has collapsed there: it is on the left of
// one and on the right of another. So of the faces on their left sides, one more is left over than
// of those on their right sides: the one on the left of the row; likewise on the right. Where none
// is left over, the same face is on both sides of the row. The edges together must give each
// rounded face one exact face.

#include <algorithm>
#include <iterator>

#include "geometry/union_find.hpp"
#include "plumbline/error.hpp"
#include "round/images.hpp"

namespace plumbline::round_steps {
namespace {

constexpr const char* kContradiction =
    "rounding keeps the topology up to merging: each face comes from one face";

class FaceOrigins {
 public:
  FaceOrigins(const Incidences& exact, const Incidences& rounded)
      : exact_(exact),
        rounded_(rounded),
        lefts_(rounded.edge_count()),
        rights_(rounded.edge_count()),
        sets_(rounded.face_count()),
        origin_(rounded.face_count()) {}

  std::vector<FaceId> run(const std::vector<VertexId>& vertex_image,
                          const Lists<HalfedgeId>& edge_image) {
    collect(edge_image);
    for (std::size_t e = 0; e < lefts_.size(); ++e) join(EdgeId(e));
    for (std::size_t e = 0; e < lefts_.size(); ++e) take_sides(EdgeId(e));
    take(kUnbounded, kUnbounded);
    for (std::size_t f = 0; f < origin_.size(); ++f) {
      origin_[f] = origin_[sets_.find(f)];
      ensure(origin_[f].valid(), kContradiction);
    }
    for (std::size_t e = 0; e < lefts_.size(); ++e) check_same_sides(EdgeId(e));
    check_isolated_vertices(vertex_image);
    return std::move(origin_);
  }

 private:
  using Faces = std::vector<FaceId>;

  void collect(const Lists<HalfedgeId>& edge_image) {
    for (std::size_t e = 0; e < edge_image.size(); ++e) {
      const FaceId left = exact_.halfedge_face[halfedge(EdgeId(e), false)];
      const FaceId right = exact_.halfedge_face[halfedge(EdgeId(e), true)];
      for (const HalfedgeId h : edge_image[e]) {
        lefts_[edge_of(h)].push_back(is_reversed(h) ? right : left);
        rights_[edge_of(h)].push_back(is_reversed(h) ? left : right);
      }
    }
    for (Faces& faces : lefts_) std::sort(faces.begin(), faces.end());
    for (Faces& faces : rights_) std::sort(faces.begin(), faces.end());
  }

  FaceId left(EdgeId e) const { return rounded_.halfedge_face[halfedge(e, false)]; }
  FaceId right(EdgeId e) const { return rounded_.halfedge_face[halfedge(e, true)]; }

  void join(EdgeId e) {
    if (lefts_[e] == rights_[e]) sets_.unite(left(e), right(e));
  }

  void take(FaceId rounded, FaceId origin) {
    FaceId& known = origin_[sets_.find(rounded)];
    ensure(!known.valid() || known == origin, kContradiction);
    known = origin;
  }

  void take_sides(EdgeId e) {
    const Faces &lefts = lefts_[e], &rights = rights_[e];
    ensure(!lefts.empty(), "a rounded edge comes from an exact one");
    if (lefts.size() == 1) {
      take(left(e), lefts.front());
      take(right(e), rights.front());
    } else if (lefts != rights) {
      Faces on_left, on_right;
      std::set_difference(lefts.begin(), lefts.end(), rights.begin(), rights.end(),
                          std::back_inserter(on_left));
      std::set_difference(rights.begin(), rights.end(), lefts.begin(), lefts.end(),
                          std::back_inserter(on_right));
      ensure(on_left.size() == 1 && on_right.size() == 1, kContradiction);
      take(left(e), on_left.front());
      take(right(e), on_right.front());
    }
  }

  void check_same_sides(EdgeId e) const {
    const Faces& faces = lefts_[e];
    if (faces != rights_[e]) return;
    ensure(std::binary_search(faces.begin(), faces.end(), origin_[left(e)]), kContradiction);
  }

  /// An isolated vertex lies in the face around one of the components that fell into it.
  void check_isolated_vertices(const std::vector<VertexId>& vertex_image) const {
    std::vector<FaceId> face(vertex_image.empty() ? 0 : rounded_.vertex_component.size());
    std::vector<bool> is_right(face.size(), true);
    for (std::size_t f = 0; f < rounded_.face_count(); ++f) {
      for (const VertexId v : rounded_.face_isolated_vertices[f]) {
        face[v] = FaceId(f);
        is_right[v] = false;
      }
    }
    for (std::size_t v = 0; v < vertex_image.size(); ++v) {
      const FaceId f = face[vertex_image[v]];
      if (f.valid() && exact_.component_parent[exact_.vertex_component[v]] == origin_[f])
        is_right[vertex_image[v]] = true;
    }
    for (const bool is : is_right) ensure(is, kContradiction);
  }

  const Incidences& exact_;
  const Incidences& rounded_;
  std::vector<Faces> lefts_, rights_;  ///< per rounded edge, of its exact ones, ascending
  UnionFind sets_;                     ///< of rounded faces
  std::vector<FaceId> origin_;         ///< per representative, in the end per rounded face
};

}  // namespace

std::vector<FaceId> face_origins(const Incidences& exact, const Incidences& rounded,
                                 const std::vector<VertexId>& vertex_image,
                                 const Lists<HalfedgeId>& edge_image) {
  return FaceOrigins(exact, rounded).run(vertex_image, edge_image);
}

}  // namespace plumbline::round_steps

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

using Faces = std::vector<FaceId>;

/// Per rounded edge the exact faces on the left and on the right of the exact edges that became it,
/// ascending.
struct Beside {
  std::vector<Faces> left, right;
};

Beside faces_beside(const Incidences& exact, const Incidences& rounded,
                    const Lists<HalfedgeId>& edge_image) {
  Beside beside{std::vector<Faces>(rounded.edge_count()), std::vector<Faces>(rounded.edge_count())};
  for (std::size_t e = 0; e < edge_image.size(); ++e) {
    const FaceId left = exact.halfedge_face[halfedge(EdgeId(e), false)];
    const FaceId right = exact.halfedge_face[halfedge(EdgeId(e), true)];
    for (const HalfedgeId h : edge_image[e]) {
      beside.left[edge_of(h)].push_back(is_reversed(h) ? right : left);
      beside.right[edge_of(h)].push_back(is_reversed(h) ? left : right);
    }
  }
  for (std::vector<Faces>* side : {&beside.left, &beside.right}) {
    for (Faces& faces : *side) std::sort(faces.begin(), faces.end());
  }
  return beside;
}

FaceId left(const Incidences& complex, EdgeId e) {
  return complex.halfedge_face[halfedge(e, false)];
}
FaceId right(const Incidences& complex, EdgeId e) {
  return complex.halfedge_face[halfedge(e, true)];
}

/// Sets of rounded faces that come from one exact face: nothing is left over between them.
UnionFind joined_faces(const Incidences& rounded, const Beside& beside) {
  UnionFind sets(rounded.face_count());
  for (std::size_t e = 0; e < rounded.edge_count(); ++e) {
    if (beside.left[e] != beside.right[e]) continue;
    sets.unite(left(rounded, EdgeId(e)), right(rounded, EdgeId(e)));
  }
  return sets;
}

/// The one face that is in the list and not in the other one.
FaceId left_over(const Faces& faces, const Faces& others) {
  if (faces.size() == 1) return faces.front();
  Faces result;
  std::set_difference(faces.begin(), faces.end(), others.begin(), others.end(),
                      std::back_inserter(result));
  ensure(result.size() == 1, kContradiction);
  return result.front();
}

/// Per rounded face the exact one that it comes from, by what is left over beside its edges.
std::vector<FaceId> origins_of(const Incidences& rounded, const Beside& beside, UnionFind sets) {
  std::vector<FaceId> origin(rounded.face_count());
  const auto take = [&](FaceId face, FaceId from) {
    FaceId& known = origin[sets.find(face)];
    ensure(!known.valid() || known == from, kContradiction);
    known = from;
  };
  for (std::size_t e = 0; e < rounded.edge_count(); ++e) {
    const Faces &lefts = beside.left[e], &rights = beside.right[e];
    ensure(!lefts.empty(), "a rounded edge comes from an exact one");
    if (lefts.size() > 1 && lefts == rights) continue;
    take(left(rounded, EdgeId(e)), left_over(lefts, rights));
    take(right(rounded, EdgeId(e)), left_over(rights, lefts));
  }
  take(kUnbounded, kUnbounded);
  for (std::size_t f = 0; f < origin.size(); ++f) {
    origin[f] = origin[sets.find(f)];
    ensure(origin[f].valid(), kContradiction);
  }
  return origin;
}

/// Where the same faces are on both sides of an edge, the face around it is one of them.
void check_same_sides(const Incidences& rounded, const Beside& beside,
                      const std::vector<FaceId>& origin) {
  for (std::size_t e = 0; e < rounded.edge_count(); ++e) {
    const Faces& faces = beside.left[e];
    if (faces != beside.right[e]) continue;
    const FaceId around = origin[left(rounded, EdgeId(e))];
    ensure(std::binary_search(faces.begin(), faces.end(), around), kContradiction);
  }
}

/// An isolated vertex lies in the face around one of the components that fell into it.
void check_isolated_vertices(const Incidences& exact, const Incidences& rounded,
                             const std::vector<VertexId>& vertex_image,
                             const std::vector<FaceId>& origin) {
  std::vector<FaceId> face(vertex_image.empty() ? 0 : rounded.vertex_component.size());
  std::vector<bool> is_right(face.size(), true);
  for (std::size_t f = 0; f < rounded.face_count(); ++f) {
    for (const VertexId v : rounded.face_isolated_vertices[f]) {
      face[v] = FaceId(f);
      is_right[v] = false;
    }
  }
  for (std::size_t v = 0; v < vertex_image.size(); ++v) {
    const FaceId f = face[vertex_image[v]];
    if (f.valid() && exact.component_parent[exact.vertex_component[v]] == origin[f]) {
      is_right[vertex_image[v]] = true;
    }
  }
  for (const bool is : is_right) ensure(is, kContradiction);
}

}  // namespace

std::vector<FaceId> face_origins(const Incidences& exact, const Incidences& rounded,
                                 const std::vector<VertexId>& vertex_image,
                                 const Lists<HalfedgeId>& edge_image) {
  const Beside beside = faces_beside(exact, rounded, edge_image);
  std::vector<FaceId> origin = origins_of(rounded, beside, joined_faces(rounded, beside));
  check_same_sides(rounded, beside, origin);
  check_isolated_vertices(exact, rounded, vertex_image, origin);
  return origin;
}

}  // namespace plumbline::round_steps

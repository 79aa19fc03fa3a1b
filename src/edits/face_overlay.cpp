#include "edits/face_overlay.hpp"

#include <algorithm>

#include "geometry/union_find.hpp"
#include "plumbline/arrange.hpp"

namespace plumbline::edits {
namespace {

/// Per vertex after the same one before, if there is one. Both are in canonical order.
std::vector<VertexId> common_vertices(const Complexes& complexes) {
  const PointList &before = complexes[Before]->vertices, &after = complexes[After]->vertices;
  std::vector<VertexId> result(after.size());
  for (std::size_t i = 0, j = 0; i < before.size() && j < after.size();) {
    const int order = PointList::compare(before, i, after, j);
    if (order == 0) result[j] = VertexId(i);
    if (order <= 0) ++i;
    if (order >= 0) ++j;
  }
  return result;
}

/// Per edge after the same one before, if there is one.
std::vector<EdgeId> common_edges(const Complexes& complexes) {
  const std::vector<VertexId> common = common_vertices(complexes);
  const std::vector<Edge>&before = complexes[Before]->edges, &after = complexes[After]->edges;
  std::vector<EdgeId> result(after.size());
  std::size_t i = 0;
  for (std::size_t j = 0; j < after.size(); ++j) {
    const VertexId tail = common[after[j].tail], head = common[after[j].head];
    if (!tail.valid() || !head.valid()) continue;
    const auto is_before = [&](const Edge& e) {
      return e.tail != tail ? e.tail < tail : e.head < head;
    };
    while (i < before.size() && is_before(before[i])) ++i;
    if (i < before.size() && before[i] == Edge{tail, head}) result[j] = EdgeId(i);
  }
  return result;
}

template <class Visit>
void for_each_halfedge(const ExactComplex& complex, FaceId f, const Visit& visit) {
  for (const HalfedgeId h : complex.cycles[complex.face_outer[f]]) visit(h);
  for (const CycleId hole : complex.face_holes[f]) {
    for (const HalfedgeId h : complex.cycles[hole]) visit(h);
  }
}

/// Per face the halfedges around it.
std::vector<std::size_t> lengths(const ExactComplex& complex) {
  std::vector<std::size_t> result(complex.face_count(), 0);
  for (const FaceId f : complex.halfedge_face) ++result[f];
  return result;
}

}  // namespace

Both<std::vector<FaceId>> changed_faces(const Complexes& complexes) {
  const std::vector<EdgeId> common = common_edges(complexes);
  const std::vector<std::size_t> before = lengths(*complexes[Before]);
  std::vector<bool> is_kept(before.size(), false);
  Both<std::vector<FaceId>> result;
  for (std::size_t f = 1; f < complexes[After]->face_count(); ++f) {
    std::size_t length = 0;
    FaceId other;
    bool is_same = true;
    for_each_halfedge(*complexes[After], FaceId(f), [&](HalfedgeId h) {
      const EdgeId e = common[edge_of(h)];
      const FaceId here =
          e.valid() ? complexes[Before]->halfedge_face[halfedge(e, is_reversed(h))] : FaceId();
      if (length == 0) other = here;
      is_same = is_same && here.valid() && here == other;
      ++length;
    });
    if (is_same && other != kUnbounded && before[other] == length) {
      is_kept[other] = true;
    } else {
      result[After].push_back(FaceId(f));
    }
  }
  for (std::size_t f = 1; f < before.size(); ++f) {
    if (!is_kept[f]) result[Before].push_back(FaceId(f));
  }
  return result;
}

namespace {

/// The edges between two faces of which one is asked for.
std::vector<EdgeId> borders(const ExactComplex& complex, const std::vector<FaceId>& faces) {
  std::vector<EdgeId> result;
  for (const FaceId f : faces) {
    for_each_halfedge(complex, f, [&](HalfedgeId h) {
      if (!complex.is_antenna(edge_of(h))) result.push_back(edge_of(h));
    });
  }
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Per face of the overlay the face of one side, of those asked for; the unbounded one stands for
/// the others, too, which no face asked for on the other side meets. Across an edge that is no
/// border of this side it is the same.
std::vector<FaceId> faces_around(const ExactComplex& overlay, const ExactComplex& complex,
                                 const std::vector<FaceId>& faces,
                                 const std::vector<EdgeId>& border) {
  UnionFind sets(overlay.face_count());
  for (std::size_t e = 0; e < border.size(); ++e) {
    if (border[e].valid()) continue;
    sets.unite(overlay.halfedge_face[halfedge(EdgeId(e), false)],
               overlay.halfedge_face[halfedge(EdgeId(e), true)]);
  }
  std::vector<FaceId> result(overlay.face_count(), kUnbounded);
  for (std::size_t e = 0; e < border.size(); ++e) {
    if (!border[e].valid()) continue;
    for (const bool is_right : {false, true}) {
      const FaceId face = complex.halfedge_face[halfedge(border[e], is_right)];
      if (!std::ranges::binary_search(faces, face)) continue;
      result[sets.find(overlay.halfedge_face[halfedge(EdgeId(e), is_right)])] = face;
    }
  }
  for (std::size_t f = 0; f < result.size(); ++f) result[f] = result[sets.find(f)];
  return result;
}

}  // namespace

FaceOverlay overlay(const Complexes& complexes, const Both<std::vector<FaceId>>& faces,
                    const std::vector<Edit>& edits) {
  SegmentSet drawing;
  const SourceId source = drawing.add_source({});
  std::vector<std::pair<Side, EdgeId>> drawn;
  for (const Side side : kSides) {
    for (const EdgeId e : borders(*complexes[side], faces[side])) {
      const Edge edge = complexes[side]->edges[e];
      drawing.add(
          Segment{complexes[side]->vertices[edge.tail], complexes[side]->vertices[edge.head]},
          source);
      drawn.emplace_back(side, e);
    }
  }
  for (const Edit& edit : edits) {
    for (const std::vector<Line>* lines : {&edit.before, &edit.after}) {
      for (const Line& line : *lines) {
        drawing.add_point(line.a, source);
        drawing.add_point(line.b, source);
      }
    }
  }
  FaceOverlay result;
  result.complex = arrange(drawing);
  Both<std::vector<EdgeId>> border;  // per side and edge of the overlay the one that covers it
  for (const Side side : kSides) border[side].resize(result.complex.edge_count());
  for (std::size_t e = 0; e < result.complex.edge_count(); ++e) {
    for (const SegmentId s : result.complex.edge_sources[e]) {
      border[drawn[s].first][e] = drawn[s].second;
    }
  }
  for (const Side side : kSides) {
    result.face[side] = faces_around(result.complex, *complexes[side], faces[side], border[side]);
    for (const EdgeId e : border[side]) result.is_border[side].push_back(e.valid());
  }
  return result;
}

}  // namespace plumbline::edits

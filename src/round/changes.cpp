#include <algorithm>

#include "plumbline/round.hpp"

namespace plumbline {
namespace {

/// Per `into` what has it as its image, if that is more than one.
template <class Merge, class Into, class From>
std::vector<Merge> several(std::vector<std::pair<Into, From>> pairs) {
  std::sort(pairs.begin(), pairs.end());
  std::vector<Merge> result;
  for (std::size_t begin = 0, end = 0; begin < pairs.size(); begin = end) {
    std::vector<From> list;
    for (end = begin; end < pairs.size() && pairs[end].first == pairs[begin].first; ++end) {
      list.push_back(pairs[end].second);
    }
    if (list.size() > 1) result.push_back({pairs[begin].first, std::move(list)});
  }
  return result;
}

template <class List>
Rational largest(const List& list) {
  Rational result = 0;
  for (const auto& item : list) result = std::max(result, item.squared_distance);
  return result;
}

void list_vertices(const ExactComplex& complex, const Rounding& rounding,
                   RoundingChanges& changes) {
  std::vector<std::pair<VertexId, VertexId>> images;
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    const VertexId image = rounding.vertex_image[v];
    images.emplace_back(image, v);
    const Point &from = complex.vertices[v], &to = rounding.complex.vertices[image];
    if (from != to) changes.moved_vertices.push_back({VertexId(v), squared_distance(from, to)});
  }
  changes.merged_vertices = several<RoundingChanges::MergedVertices>(std::move(images));
}

void list_edges(const ExactComplex& complex, const Rounding& rounding, RoundingChanges& changes) {
  std::vector<std::pair<EdgeId, EdgeId>> images;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const auto image = rounding.edge_image[e];
    for (const HalfedgeId h : image) images.emplace_back(edge_of(h), e);
    if (image.empty()) changes.vanished_edges.emplace_back(e);
    if (image.size() < 2) continue;
    const Edge& edge = complex.edges[e];
    RoundingChanges::Bend bend{EdgeId(e), 0};
    for (const HalfedgeId h : image.first(image.size() - 1)) {
      const Point& p = rounding.complex.vertices[rounding.complex.target(h)];
      bend.squared_distance =
          std::max(bend.squared_distance,
                   squared_distance(p, complex.vertices[edge.tail], complex.vertices[edge.head]));
    }
    changes.bent_edges.push_back(std::move(bend));
  }
  changes.merged_edges = several<RoundingChanges::MergedEdges>(std::move(images));
}

void list_faces(const ExactComplex& complex, const Rounding& rounding, RoundingChanges& changes) {
  std::vector<std::pair<FaceId, FaceId>> origins;
  std::vector<bool> is_left(complex.face_count());
  for (std::size_t f = 0; f < rounding.face_origin.size(); ++f) {
    origins.emplace_back(rounding.face_origin[f], f);
    is_left[rounding.face_origin[f]] = true;
  }
  for (std::size_t f = 0; f < is_left.size(); ++f) {
    if (!is_left[f]) changes.vanished_faces.emplace_back(f);
  }
  changes.split_faces = several<RoundingChanges::SplitFace>(std::move(origins));
}

}  // namespace

Rational RoundingChanges::largest_squared_movement() const { return largest(moved_vertices); }
Rational RoundingChanges::largest_squared_bend() const { return largest(bent_edges); }

RoundingChanges changes(const ExactComplex& complex, const Rounding& rounding) {
  RoundingChanges result;
  list_vertices(complex, rounding, result);
  list_edges(complex, rounding, result);
  list_faces(complex, rounding, result);
  return result;
}

}  // namespace plumbline

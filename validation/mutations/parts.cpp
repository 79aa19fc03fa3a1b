#include "mutations/parts.hpp"

#include <algorithm>

#include "plumbline/arrange.hpp"

namespace plumbline::mutations {
namespace {

template <class T>
std::vector<std::vector<T>> unpacked(const Lists<T>& lists) {
  std::vector<std::vector<T>> result;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    result.emplace_back(lists[i].begin(), lists[i].end());
  }
  return result;
}

template <class T>
Lists<T> packed(const std::vector<std::vector<T>>& lists) {
  Lists<T> result;
  for (const auto& list : lists) result.push_back(list);
  return result;
}

}  // namespace

Parts::Parts(const ExactComplex& complex)
    : vertices(complex.vertices.begin(), complex.vertices.end()),
      edges(complex.edges),
      edge_sources(unpacked(complex.edge_sources)),
      cycles(unpacked(complex.cycles)),
      outer(complex.face_outer),
      holes(unpacked(complex.face_holes)),
      isolated(unpacked(complex.face_isolated_vertices)) {}

ExactComplex Parts::complex() const {
  ExactComplex result;
  result.vertices = PointList(vertices);
  result.edges = edges;
  result.edge_sources = packed(edge_sources);
  result.cycles = packed(cycles);
  result.face_outer = outer;
  result.face_holes = packed(holes);
  result.face_isolated_vertices = packed(isolated);
  return canonical(std::move(result));
}

void Parts::add_edge(VertexId tail, VertexId head) {
  edges.push_back({tail, head});
  edge_sources.emplace_back();
}

void Parts::drop_cycles(const std::vector<bool>& is_dropped) {
  std::vector<CycleId> renumbered(cycles.size());
  std::vector<std::vector<HalfedgeId>> kept;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    if (is_dropped[i]) continue;
    renumbered[i] = CycleId(kept.size());
    kept.push_back(cycles[i]);
  }
  cycles = kept;
  for (std::size_t f = outer.size(); f-- > 0;) {
    if (f != kUnbounded) {
      outer[f] = renumbered[outer[f]];
      if (!outer[f].valid()) {
        const auto at = static_cast<std::ptrdiff_t>(f);
        outer.erase(outer.begin() + at);
        holes.erase(holes.begin() + at);
        isolated.erase(isolated.begin() + at);
        continue;
      }
    }
    std::vector<CycleId> left;
    for (const CycleId hole : holes[f]) {
      if (renumbered[hole].valid()) left.push_back(renumbered[hole]);
    }
    holes[f] = left;
  }
}

Drawing::Drawing(const ExactComplex& complex) : sources(unpacked(complex.edge_sources)) {
  for (const Edge& e : complex.edges) {
    segments.push_back({complex.vertices[e.tail], complex.vertices[e.head]});
  }
  for (const VertexId v : complex.face_isolated_vertices.flat()) {
    points.push_back(complex.vertices[v]);
  }
}

void Drawing::add(const Point& a, const Point& b) {
  segments.push_back({a, b});
  sources.emplace_back();
}

ExactComplex Drawing::arranged() const {
  SegmentSet set;
  std::vector<std::size_t> original;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments[i].a == segments[i].b) continue;
    set.add(segments[i], SourceId());
    original.push_back(i);
  }
  for (const Point& p : points) set.add_point(p, SourceId());
  ExactComplex result = arrange(set, ExactEngine::Bucket, {1, {}});
  Lists<SegmentId> named;
  for (std::size_t e = 0; e < result.edge_count(); ++e) {
    std::vector<SegmentId> ids;
    for (const SegmentId s : result.edge_sources[e]) {
      const auto& of_segment = sources[original[s]];
      ids.insert(ids.end(), of_segment.begin(), of_segment.end());
    }
    named.push_back(ids);
  }
  result.edge_sources = named;
  return canonical(std::move(result));
}

Right::Right(const ExactComplex& complex, unsigned seed)
    : complex_(complex), random_(seed), neighbours_(complex.vertices.size()), small_(1) {
  for (const Edge& e : complex.edges) {
    neighbours_[e.tail].push_back(e.head);
    neighbours_[e.head].push_back(e.tail);
  }
  for (auto& list : neighbours_) std::sort(list.begin(), list.end());
  if (complex.edge_count() == 0) return;
  const FeatureSize features = feature_size(complex);
  Rational squared = features.squared_vertex_vertex;
  if (features.edge.valid()) squared = std::min(squared, features.squared_vertex_edge);
  small_ = rational_from(nearest_sqrt(squared)) / 4;
}

Point Right::middle(EdgeId e) const {
  return {(tail(e).x + head(e).x) / 2, (tail(e).y + head(e).y) / 2};
}

Point Right::small_step() {
  const Rational length = below(2) == 0 ? small_ : Rational(-small_);
  return below(2) == 0 ? Point{length, 0} : Point{0, length};
}

std::vector<Point> ends(const Right& right, EdgeId e) { return {right.tail(e), right.head(e)}; }

}  // namespace plumbline::mutations

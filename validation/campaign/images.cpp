#include "campaign/images.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace plumbline::campaign {

namespace {

/// The cycles seen from below: walked backwards, on the other sides of their edges.
Lists<HalfedgeId> turned_over(const Lists<HalfedgeId>& cycles) {
  Lists<HalfedgeId> result;
  for (std::size_t c = 0; c < cycles.size(); ++c) {
    std::vector<HalfedgeId> cycle;
    for (const HalfedgeId h : cycles[c]) cycle.insert(cycle.begin(), twin(h));
    result.push_back(cycle);
  }
  return result;
}

template <class Id>
std::vector<Id> shifted(std::span<const Id> ids, std::size_t by) {
  std::vector<Id> result;
  for (const Id id : ids) result.emplace_back(id + by);
  return result;
}

/// Lists of both, the first of which are joined.
template <class Id>
Lists<Id> joined_first(const Lists<Id>& lists, std::size_t by) {
  std::vector<Id> first(lists[0].begin(), lists[0].end());
  const std::vector<Id> more = shifted(lists[0], by);
  first.insert(first.end(), more.begin(), more.end());
  Lists<Id> result;
  result.push_back(first);
  for (std::size_t i = 1; i < lists.size(); ++i) result.push_back(lists[i]);
  for (std::size_t i = 1; i < lists.size(); ++i) result.push_back(shifted(lists[i], by));
  return result;
}

}  // namespace

ExactComplex renamed(ExactComplex complex, const std::vector<SegmentId>& original) {
  Lists<SegmentId> sources;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    std::vector<SegmentId> ids;
    for (const SegmentId s : complex.edge_sources[e]) ids.push_back(original.at(s));
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    sources.push_back(ids);
  }
  complex.edge_sources = std::move(sources);
  return complex;
}

int determinant_sign(const Affine& map) {
  return sgn(map(0, 0) * map(1, 1) - map(0, 1) * map(1, 0));
}

ExactComplex mapped(ExactComplex complex, const Affine& map) {
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    complex.vertices.replace(v, apply(map, complex.vertices[v]));
  }
  if (determinant_sign(map) < 0) complex.cycles = turned_over(complex.cycles);
  return canonical(std::move(complex));
}

ExactComplex with_vertex(ExactComplex complex, const Point& p) {
  if (std::find(complex.vertices.begin(), complex.vertices.end(), p) != complex.vertices.end()) {
    return complex;
  }
  std::size_t cut = 0;
  const auto end = [&](VertexId v) { return complex.vertices[v]; };
  while (cut < complex.edge_count() &&
         !on_segment(end(complex.edges[cut].tail), end(complex.edges[cut].head), p)) {
    ++cut;
  }
  ensure(cut < complex.edge_count(), "a place on a segment is on an edge");
  const EdgeId old(cut), rest(complex.edge_count());
  const VertexId added(complex.vertices.size());
  complex.vertices.push_back(p);
  complex.edges.push_back({added, complex.edges[old].head});
  complex.edges[old].head = added;
  const std::vector<SegmentId> sources(complex.edge_sources[old].begin(),
                                       complex.edge_sources[old].end());
  complex.edge_sources.push_back(sources);
  Lists<HalfedgeId> cycles;
  for (std::size_t c = 0; c < complex.cycles.size(); ++c) {
    std::vector<HalfedgeId> cycle;
    for (const HalfedgeId h : complex.cycles[c]) {
      if (h == halfedge(old, true)) cycle.push_back(halfedge(rest, true));
      cycle.push_back(h);
      if (h == halfedge(old, false)) cycle.push_back(halfedge(rest, false));
    }
    cycles.push_back(cycle);
  }
  complex.cycles = std::move(cycles);
  return canonical(std::move(complex));
}

ExactComplex with_copy(const ExactComplex& complex, const Affine& move, std::size_t segments) {
  ExactComplex both = complex;
  for (const Point& p : complex.vertices) both.vertices.push_back(apply(move, p));
  const std::size_t vertices = complex.vertices.size(), cycles = complex.cycles.size();
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const Edge& edge = complex.edges[e];
    both.edges.push_back({VertexId(edge.tail + vertices), VertexId(edge.head + vertices)});
    both.edge_sources.push_back(shifted(complex.edge_sources[e], segments));
  }
  for (std::size_t c = 0; c < cycles; ++c) {
    both.cycles.push_back(shifted(complex.cycles[c], 2 * complex.edge_count()));
  }
  for (std::size_t f = 1; f < complex.face_count(); ++f) {
    both.face_outer.emplace_back(complex.face_outer[f] + cycles);
  }
  both.face_holes = joined_first(complex.face_holes, cycles);
  both.face_isolated_vertices = joined_first(complex.face_isolated_vertices, vertices);
  return canonical(std::move(both));
}

ExactComplex sourced_by_itself(ExactComplex complex) {
  Lists<SegmentId> sources;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    sources.push_back(std::array{SegmentId(e)});
  }
  complex.edge_sources = std::move(sources);
  return complex;
}

}  // namespace plumbline::campaign

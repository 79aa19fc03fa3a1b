// Brings a complex into canonical order: vertices, then edges, cycles and faces, each renumbered by
// the order of the one before it; then the derived members are computed anew.

#include <algorithm>
#include <numeric>
#include <utility>

#include "complex/derive.hpp"
#include "plumbline/complex.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

/// old index -> new index, and its inverse.
template <class Id>
struct Renumbering {
  std::vector<Id> new_of_old;
  std::vector<Id> old_of_new;
};

template <class Id, class Less>
Renumbering<Id> sorted_by(std::size_t count, Less less) {
  Renumbering<Id> order;
  order.old_of_new.reserve(count);
  for (std::size_t i = 0; i < count; ++i) order.old_of_new.emplace_back(i);
  std::stable_sort(order.old_of_new.begin(), order.old_of_new.end(), less);
  order.new_of_old.resize(count);
  for (std::size_t i = 0; i < count; ++i) order.new_of_old[order.old_of_new[i]] = Id(i);
  return order;
}

void ensure_indices(const Incidences& c, std::size_t vertex_count) {
  ensure(!c.face_outer.empty() && !c.face_outer[0].valid(),
         "a complex has an unbounded face 0 without outer boundary");
  ensure(c.edge_sources.size() == c.edges.size(), "a complex has sources for each edge");
  ensure(c.face_holes.size() == c.face_outer.size(), "a complex has a list of holes for each face");
  ensure(c.face_isolated_vertices.size() == c.face_outer.size(),
         "a complex has a list of isolated vertices for each face");
  for (const Edge& e : c.edges) {
    ensure(e.tail < vertex_count && e.head < vertex_count, "an edge joins two vertices");
  }
  for (const HalfedgeId h : c.cycles.flat()) {
    ensure(h < 2 * c.edges.size(), "a cycle consists of halfedges");
  }
  for (std::size_t i = 0; i < c.cycles.size(); ++i)
    ensure(!c.cycles[i].empty(), "no cycle is empty");
  for (std::size_t f = 1; f < c.face_outer.size(); ++f) {
    ensure(c.face_outer[f] < c.cycles.size(), "a bounded face has an outer boundary");
  }
  for (const CycleId h : c.face_holes.flat()) ensure(h < c.cycles.size(), "a hole is a cycle");
  for (const VertexId v : c.face_isolated_vertices.flat()) {
    ensure(v < vertex_count, "an isolated vertex is a vertex");
  }
}

/// Renumbers and sorts edges; returns the map of halfedges.
std::vector<HalfedgeId> reorder_edges(Incidences& c, const Renumbering<VertexId>& vertices) {
  std::vector<bool> flipped(c.edges.size());
  for (std::size_t i = 0; i < c.edges.size(); ++i) {
    Edge e{vertices.new_of_old[c.edges[i].tail], vertices.new_of_old[c.edges[i].head]};
    flipped[i] = e.head < e.tail;
    if (flipped[i]) std::swap(e.tail, e.head);
    c.edges[i] = e;
  }
  const auto order = sorted_by<EdgeId>(c.edges.size(), [&](EdgeId i, EdgeId j) {
    const Edge &e = c.edges[i], &f = c.edges[j];
    return e.tail != f.tail ? e.tail < f.tail : e.head < f.head;
  });
  std::vector<Edge> edges;
  Lists<SegmentId> sources;
  edges.reserve(c.edges.size());
  for (const EdgeId old : order.old_of_new) {
    edges.push_back(c.edges[old]);
    std::vector<SegmentId> list(c.edge_sources[old].begin(), c.edge_sources[old].end());
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    sources.push_back(list);
  }
  std::vector<HalfedgeId> halfedges(2 * c.edges.size());
  for (std::size_t h = 0; h < halfedges.size(); ++h) {
    const EdgeId old = edge_of(HalfedgeId(h));
    halfedges[h] = halfedge(order.new_of_old[old], is_reversed(HalfedgeId(h)) != flipped[old]);
  }
  c.edges = std::move(edges);
  c.edge_sources = std::move(sources);
  return halfedges;
}

/// Renumbers cycles; each starts at its least halfedge. Returns the map of cycles.
std::vector<CycleId> reorder_cycles(Incidences& c, const std::vector<HalfedgeId>& halfedges) {
  Lists<HalfedgeId> cycles;
  std::vector<HalfedgeId> cycle;
  for (std::size_t i = 0; i < c.cycles.size(); ++i) {
    cycle.clear();
    for (const HalfedgeId h : c.cycles[i]) cycle.push_back(halfedges[h]);
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    cycles.push_back(cycle);
  }
  const auto order = sorted_by<CycleId>(cycles.size(), [&](CycleId i, CycleId j) {
    return std::ranges::lexicographical_compare(cycles[i], cycles[j]);
  });
  c.cycles = Lists<HalfedgeId>();
  for (const CycleId old : order.old_of_new) c.cycles.push_back(cycles[old]);
  return order.new_of_old;
}

template <class Id>
std::vector<Id> renumbered(std::span<const Id> list, const std::vector<Id>& new_of_old) {
  std::vector<Id> result;
  result.reserve(list.size());
  for (const Id id : list) result.push_back(new_of_old[id]);
  std::sort(result.begin(), result.end());
  return result;
}

void reorder_faces(Incidences& c, const std::vector<CycleId>& cycles,
                   const std::vector<VertexId>& vertices) {
  for (std::size_t f = 1; f < c.face_outer.size(); ++f) c.face_outer[f] = cycles[c.face_outer[f]];
  const auto order = sorted_by<FaceId>(c.face_outer.size(), [&](FaceId f, FaceId g) {
    if (f == kUnbounded || g == kUnbounded) return f == kUnbounded && g != kUnbounded;
    return c.face_outer[f] < c.face_outer[g];
  });
  std::vector<CycleId> outer;
  Lists<CycleId> holes;
  Lists<VertexId> isolated;
  outer.reserve(c.face_outer.size());
  for (const FaceId old : order.old_of_new) {
    outer.push_back(c.face_outer[old]);
    holes.push_back(renumbered(c.face_holes[old], cycles));
    isolated.push_back(renumbered(c.face_isolated_vertices[old], vertices));
  }
  c.face_outer = std::move(outer);
  c.face_holes = std::move(holes);
  c.face_isolated_vertices = std::move(isolated);
}

const PointD& rounded(const PointD& p) { return p; }
PointD rounded(const Point& p) { return nearest(p); }

/// Order by (x, y). Rounding is monotone, so only what rounds to equal doubles is compared exactly.
template <class P>
Renumbering<VertexId> sorted_vertices(const std::vector<P>& points) {
  std::vector<PointD> approx;
  approx.reserve(points.size());
  for (const P& p : points) approx.push_back(rounded(p));
  return sorted_by<VertexId>(points.size(), [&](VertexId v, VertexId w) {
    if (approx[v].x != approx[w].x) return approx[v].x < approx[w].x;
    return points[v] < points[w];
  });
}

template <class P>
CellComplex<P> in_canonical_order(CellComplex<P> c) {
  ensure_indices(c, c.vertices.size());
  const auto vertices = sorted_vertices(c.vertices);
  std::vector<P> points;
  points.reserve(c.vertices.size());
  for (const VertexId old : vertices.old_of_new) points.push_back(std::move(c.vertices[old]));
  c.vertices = std::move(points);
  const std::vector<HalfedgeId> halfedges = reorder_edges(c, vertices);
  const std::vector<CycleId> cycles = reorder_cycles(c, halfedges);
  reorder_faces(c, cycles, vertices.new_of_old);
  derive(c, c.vertices.size());
  return c;
}

}  // namespace

ExactComplex canonical(ExactComplex complex) { return in_canonical_order(std::move(complex)); }
FloatComplex canonical(FloatComplex complex) { return in_canonical_order(std::move(complex)); }

}  // namespace plumbline

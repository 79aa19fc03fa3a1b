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

template <class Id>
Renumbering<Id> renumbering(std::vector<Id> old_of_new) {
  Renumbering<Id> order{std::vector<Id>(old_of_new.size()), std::move(old_of_new)};
  for (std::size_t i = 0; i < order.old_of_new.size(); ++i) {
    order.new_of_old[order.old_of_new[i]] = Id(i);
  }
  return order;
}

/// Equal ones keep their order. What is made of a canonical complex is mostly in order.
template <class T, class Less>
void sort_if_needed(std::vector<T>& things, Less less) {
  if (std::is_sorted(things.begin(), things.end(), less)) return;
  std::stable_sort(things.begin(), things.end(), less);
}

template <class Id, class Less>
Renumbering<Id> sorted_by(std::size_t count, Less less) {
  std::vector<Id> ids;
  ids.reserve(count);
  for (std::size_t i = 0; i < count; ++i) ids.emplace_back(i);
  sort_if_needed(ids, less);
  return renumbering(std::move(ids));
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
  for (std::size_t i = 0; i < c.cycles.size(); ++i) {
    ensure(!c.cycles[i].empty(), "no cycle is empty");
  }
  for (std::size_t f = 1; f < c.face_outer.size(); ++f) {
    ensure(c.face_outer[f] < c.cycles.size(), "a bounded face has an outer boundary");
  }
  for (const CycleId h : c.face_holes.flat()) ensure(h < c.cycles.size(), "a hole is a cycle");
  for (const VertexId v : c.face_isolated_vertices.flat()) {
    ensure(v < vertex_count, "an isolated vertex is a vertex");
  }
}

/// Edges by (tail, head): by tail in one pass, for there are as many tails as vertices.
Renumbering<EdgeId> sorted_edges(const std::vector<Edge>& edges, std::size_t vertex_count) {
  std::vector<std::uint32_t> begin(vertex_count + 1);
  for (const Edge& e : edges) ++begin[e.tail + std::size_t{1}];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<EdgeId> ids(edges.size());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t i = 0; i < edges.size(); ++i) ids[next[edges[i].tail]++] = EdgeId(i);
  const auto is_before = [&](EdgeId i, EdgeId j) {
    return edges[i].head != edges[j].head ? edges[i].head < edges[j].head : i < j;
  };
  for (std::size_t v = 0; v < vertex_count; ++v) {
    std::sort(ids.begin() + begin[v], ids.begin() + begin[v + 1], is_before);
  }
  return renumbering(std::move(ids));
}

/// Each list ascending, nothing twice.
Lists<SegmentId> sorted_sources(const Lists<SegmentId>& sources,
                                const std::vector<EdgeId>& old_of_new) {
  Lists<SegmentId> result;
  result.reserve(sources.size(), sources.flat().size());
  std::vector<SegmentId> list;
  for (const EdgeId old : old_of_new) {
    list.assign(sources[old].begin(), sources[old].end());
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    result.push_back(list);
  }
  return result;
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
  const auto order = sorted_edges(c.edges, vertices.new_of_old.size());
  std::vector<Edge> edges;
  edges.reserve(c.edges.size());
  for (const EdgeId old : order.old_of_new) edges.push_back(c.edges[old]);
  std::vector<HalfedgeId> halfedges(2 * c.edges.size());
  for (std::size_t h = 0; h < halfedges.size(); ++h) {
    const EdgeId old = edge_of(HalfedgeId(h));
    halfedges[h] = halfedge(order.new_of_old[old], is_reversed(HalfedgeId(h)) != flipped[old]);
  }
  c.edges = std::move(edges);
  c.edge_sources = sorted_sources(c.edge_sources, order.old_of_new);
  return halfedges;
}

/// Renumbers cycles; each starts at its least halfedge. Returns the map of cycles.
std::vector<CycleId> reorder_cycles(Incidences& c, const std::vector<HalfedgeId>& halfedges) {
  Lists<HalfedgeId> cycles;
  cycles.reserve(c.cycles.size(), c.cycles.flat().size());
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
  c.cycles.reserve(cycles.size(), cycles.flat().size());
  for (const CycleId old : order.old_of_new) c.cycles.push_back(cycles[old]);
  return order.new_of_old;
}

template <class Id>
Lists<Id> renumbered(const Lists<Id>& lists, const std::vector<FaceId>& old_of_new,
                     const std::vector<Id>& new_of_old) {
  Lists<Id> result;
  result.reserve(lists.size(), lists.flat().size());
  std::vector<Id> list;
  for (const FaceId old : old_of_new) {
    list.clear();
    for (const Id id : lists[old]) list.push_back(new_of_old[id]);
    std::sort(list.begin(), list.end());
    result.push_back(list);
  }
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
  outer.reserve(c.face_outer.size());
  for (const FaceId old : order.old_of_new) outer.push_back(c.face_outer[old]);
  c.face_outer = std::move(outer);
  c.face_holes = renumbered(c.face_holes, order.old_of_new, cycles);
  c.face_isolated_vertices = renumbered(c.face_isolated_vertices, order.old_of_new, vertices);
}

PointD rounded(const std::vector<PointD>& points, std::size_t v) { return points[v]; }
PointD rounded(const PointList& points, std::size_t v) { return points.nearest(v); }
int compare(const std::vector<PointD>& points, std::size_t v, std::size_t w) {
  return points[v] < points[w] ? -1 : (points[w] < points[v] ? 1 : 0);
}
int compare(const PointList& points, std::size_t v, std::size_t w) { return points.compare(v, w); }

/// Order by (x, y). Rounding is monotone, so only what rounds to equal doubles is compared exactly.
template <class Points>
Renumbering<VertexId> sorted_vertices(const Points& points) {
  struct Key {
    double x;
    VertexId v;
  };
  std::vector<Key> keys;
  keys.reserve(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    keys.push_back({rounded(points, v).x, VertexId(v)});
  }
  sort_if_needed(keys, [&](const Key& a, const Key& b) {
    return a.x != b.x ? a.x < b.x : compare(points, a.v, b.v) < 0;
  });
  std::vector<VertexId> ids;
  ids.reserve(keys.size());
  for (const Key& key : keys) ids.push_back(key.v);
  return renumbering(std::move(ids));
}

void reorder(std::vector<PointD>& points, const std::vector<VertexId>& old_of_new) {
  std::vector<PointD> result;
  result.reserve(points.size());
  for (const VertexId old : old_of_new) result.push_back(points[old]);
  points = std::move(result);
}
void reorder(PointList& points, const std::vector<VertexId>& old_of_new) {
  points.reorder(old_of_new);
}

template <class Points>
CellComplex<Points> in_canonical_order(CellComplex<Points> c) {
  ensure_indices(c, c.vertices.size());
  const auto vertices = sorted_vertices(c.vertices);
  reorder(c.vertices, vertices.old_of_new);
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

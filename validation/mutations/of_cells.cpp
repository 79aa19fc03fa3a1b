// Vertices and edges that are too many, or fewer than they must be.

#include <algorithm>

#include "mutations/mutations.hpp"

namespace plumbline::mutations {
namespace {

std::optional<Broken> repeat_edge(Right& right) {
  const EdgeId e = right.edge([](EdgeId) { return true; });
  if (!e.valid()) return {};
  Parts parts(*right);
  parts.add_edge(parts.edges[e].tail, parts.edges[e].head);
  return Broken{parts.complex(),
                0,
                {broken(Invariant::DuplicateEdge), {CellKind::Edge, Disagreement::Split}},
                ends(right, e)};
}

std::optional<Broken> add_zero_edge(Right& right) {
  const VertexId v = right.vertex([](VertexId) { return true; });
  if (!v.valid()) return {};
  Parts parts(*right);
  parts.add_edge(v, v);
  return Broken{parts.complex(), 0, {broken(Invariant::Index)}, {right.point(v)}};
}

std::optional<Broken> repeat_vertex(Right& right) {
  const VertexId v = right.vertex([](VertexId) { return true; });
  if (!v.valid()) return {};
  Parts parts(*right);
  parts.vertices.push_back(parts.vertices[v]);
  parts.isolated[kUnbounded].emplace_back(parts.vertices.size() - 1);
  return Broken{parts.complex(),
                0,
                {broken(Invariant::DuplicateVertex), {CellKind::Vertex, Disagreement::Split}},
                {right.point(v)}};
}

/// A vertex on an edge that does not end there.
std::optional<Broken> touch_edge(Right& right) {
  const EdgeId e = right.edge([](EdgeId) { return true; });
  if (!e.valid()) return {};
  Parts parts(*right);
  parts.vertices.push_back(right.middle(e));
  parts.isolated[right->halfedge_face[halfedge(e, false)]].emplace_back(parts.vertices.size() - 1);
  return Broken{parts.complex(),
                0,
                {broken(Invariant::VertexOnEdge), {CellKind::Vertex, Disagreement::Extra}},
                {right.middle(e)}};
}

/// An edge through others.
std::optional<Broken> cross_edges(Right& right) {
  if (right->edge_count() == 0) return {};
  constexpr int kTries = 50;
  for (int i = 0; i < kTries; ++i) {
    const VertexId v(right.below(right->vertices.size())), w(right.below(right->vertices.size()));
    const EdgeId e(right.below(right->edge_count()));
    if (v == w) continue;
    const auto side = [&](const Segment& s, const Point& p) { return orientation(s.a, s.b, p); };
    const Segment s{right.point(v), right.point(w)}, t{right.tail(e), right.head(e)};
    if (side(s, t.a) * side(s, t.b) >= 0 || side(t, s.a) * side(t, s.b) >= 0) continue;
    Parts parts(*right);
    parts.add_edge(v, w);
    return Broken{parts.complex(),
                  0,
                  {broken(Invariant::Crossing), {CellKind::Edge, Disagreement::Extra}},
                  {s.a, s.b}};
  }
  return {};
}

std::vector<HalfedgeId> leaving(const Right& right, VertexId v) {
  std::vector<HalfedgeId> result;
  for (std::size_t h = 0; h < 2 * right->edge_count(); ++h) {
    if (right->origin(HalfedgeId(h)) == v) result.emplace_back(h);
  }
  return result;
}

/// The halfedge out of v that runs straight on from where h, another one, came to v; or none.
HalfedgeId opposite(const Right& right, VertexId v, HalfedgeId h) {
  for (const HalfedgeId g : leaving(right, v)) {
    if (edge_of(g) != edge_of(h) && orientation(right.point(right->target(h)), right.point(v),
                                                right.point(right->target(g))) == 0) {
      return g;
    }
  }
  return {};
}

/// Leaves out edges, and cycles of which nothing is left.
void drop_edges(Parts& parts, const std::vector<bool>& is_gone) {
  std::vector<EdgeId> renumbered(parts.edges.size());
  std::size_t count = 0;
  for (std::size_t e = 0; e < parts.edges.size(); ++e) {
    if (is_gone[e]) continue;
    renumbered[e] = EdgeId(count);
    parts.edges[count] = parts.edges[e];
    parts.edge_sources[count++] = parts.edge_sources[e];
  }
  parts.edges.resize(count);
  parts.edge_sources.resize(count);
  std::vector<bool> is_dropped(parts.cycles.size());
  for (std::size_t c = 0; c < parts.cycles.size(); ++c) {
    std::vector<HalfedgeId> walk;
    for (const HalfedgeId h : parts.cycles[c]) {
      if (renumbered[edge_of(h)].valid()) {
        walk.push_back(halfedge(renumbered[edge_of(h)], is_reversed(h)));
      }
    }
    parts.cycles[c] = walk;
    is_dropped[c] = walk.empty();
  }
  parts.drop_cycles(is_dropped);
}

/// Leaves out a vertex of no edge.
void drop_vertex(Parts& parts, VertexId v) {
  const auto lower = [&](VertexId w) { return VertexId(w - (w > v ? 1U : 0U)); };
  parts.vertices.erase(parts.vertices.begin() + static_cast<std::ptrdiff_t>(v));
  for (Edge& e : parts.edges) e = {lower(e.tail), lower(e.head)};
  for (auto& list : parts.isolated) {
    for (VertexId& w : list) w = lower(w);
  }
}

/// Two lines that cross without a vertex.
std::optional<Broken> forget_crossing(Right& right) {
  const VertexId v = right.vertex([&](VertexId i) {
    if (right.neighbours(i).size() != 4) return false;
    const auto all = leaving(right, i);
    return std::all_of(all.begin(), all.end(),
                       [&](HalfedgeId h) { return opposite(right, i, h).valid(); });
  });
  if (!v.valid()) return {};
  // In each line the edge that ends at v takes the place of both; the vertex goes.
  Parts parts(*right);
  std::vector<bool> is_gone(parts.edges.size());
  for (const HalfedgeId h : leaving(right, v)) {
    if (is_reversed(h)) continue;
    const EdgeId before = edge_of(opposite(right, v, h));
    parts.edges[before].head = parts.edges[edge_of(h)].head;
    is_gone[edge_of(h)] = true;
  }
  drop_edges(parts, is_gone);
  drop_vertex(parts, v);
  std::vector<Point> places{right.point(v)};
  for (const VertexId w : right.neighbours(v)) places.push_back(right.point(w));
  return Broken{parts.complex(),
                0,
                {broken(Invariant::Crossing),
                 {CellKind::Vertex, Disagreement::Missing},
                 {CellKind::Edge, Disagreement::Merged}},
                places};
}

}  // namespace

const std::vector<Mutation>& of_cells() {
  static const std::vector<Mutation> list{
      {"repeat an edge", repeat_edge},    {"add an edge without length", add_zero_edge},
      {"repeat a vertex", repeat_vertex}, {"touch an edge", touch_edge},
      {"cross edges", cross_edges},       {"forget a crossing", forget_crossing},
  };
  return list;
}

}  // namespace plumbline::mutations

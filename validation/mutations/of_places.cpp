// Vertices in other places; every list of cells stays as it was.

#include <algorithm>

#include "mutations/mutations.hpp"

namespace plumbline::mutations {
namespace {

constexpr Name kMoved{CellKind::Vertex, Disagreement::Moved};

/// The half of the small length, as the tolerance of the comparison.
double tolerance(const Right& right) { return nearest_double(right.small()) / 2; }

Broken with_vertex_at(const Right& right, VertexId v, const Point& p) {
  Parts parts(*right);
  parts.vertices[v] = p;
  return {parts.complex(), tolerance(right), {kMoved}, {right.point(v), p}, 2};
}

VertexId with_edges(Right& right) {
  return right.vertex([&](VertexId v) { return !right.neighbours(v).empty(); });
}

std::optional<Broken> move_a_little(Right& right) {
  const VertexId v = with_edges(right);
  if (!v.valid()) return {};
  const Point p = right.point(v), step = right.small_step();
  Broken result = with_vertex_at(right, v, {p.x + step.x, p.y + step.y});
  result.groups = 1;
  return result;
}

/// To the middle of some edge, and then some: edges cross, or faces turn over.
std::optional<Broken> move_a_lot(Right& right) {
  const VertexId v = with_edges(right);
  if (!v.valid() || right->vertices.size() < 3) return {};
  const Point q = right.point(VertexId(right.below(right->vertices.size())));
  const Point r = right.point(VertexId(right.below(right->vertices.size())));
  const Point step = right.small_step();
  const Point p{q.x + (r.x - q.x) / 3 + step.x, q.y + (r.y - q.y) / 3 + step.y};
  const auto is_near = [&](const Point& other) {
    return squared_distance(p, other) <= right.small() * right.small();
  };
  if (std::any_of(right->vertices.begin(), right->vertices.end(), is_near)) return {};
  return with_vertex_at(right, v, p);
}

std::optional<Broken> move_onto_edge(Right& right) {
  const VertexId v = with_edges(right);
  if (!v.valid()) return {};
  const EdgeId e =
      right.edge([&](EdgeId i) { return right->edges[i].tail != v && right->edges[i].head != v; });
  if (!e.valid()) return {};
  Broken result = with_vertex_at(right, v, right.middle(e));
  result.names.push_back(broken(Invariant::VertexOnEdge));
  return result;
}

std::optional<Broken> move_onto_vertex(Right& right) {
  if (right->vertices.size() < 2) return {};
  const VertexId v(right.below(right->vertices.size())), w(right.below(right->vertices.size()));
  if (v == w) return {};
  Broken result = with_vertex_at(right, v, right.point(w));
  result.names = {broken(Invariant::DuplicateVertex)};
  return result;
}

/// Whether an edge of v to another vertex than w has nothing along it once they are exchanged.
bool loses_edge(const Right& right, VertexId v, VertexId w) {
  const auto& others = right.neighbours(w);
  const Point &p = right.point(v), &q = right.point(w);
  return std::any_of(right.neighbours(v).begin(), right.neighbours(v).end(), [&](VertexId n) {
    const auto is_along = [&](VertexId m) {
      return orientation(p, right.point(n), right.point(m)) == 0;
    };
    return n != w && orientation(q, p, right.point(n)) != 0 &&
           std::none_of(others.begin(), others.end(), is_along);
  });
}

/// Two vertices in each other's place.
std::optional<Broken> exchange_vertices(Right& right) {
  const VertexId v = with_edges(right);
  const VertexId w =
      right.vertex([&](VertexId i) { return v.valid() && i != v && loses_edge(right, v, i); });
  if (!v.valid() || !w.valid()) return {};
  Parts parts(*right);
  std::swap(parts.vertices[v], parts.vertices[w]);
  Broken result{parts.complex(), 0, {{CellKind::Edge, Disagreement::Missing}}, {}};
  for (const VertexId i : {v, w}) {
    result.places.push_back(right.point(i));
    for (const VertexId n : right.neighbours(i)) result.places.push_back(right.point(n));
  }
  result.groups = result.places.size();
  return result;
}

template <class Map>
Broken with_all(const Right& right, Map map) {
  Parts parts(*right);
  Broken result;
  for (Point& p : parts.vertices) {
    result.places.push_back(p);
    p = map(p);
  }
  result.complex = parts.complex();
  return result;
}

/// The farthest vertex is off by a little, the origin by nothing.
std::optional<Broken> scale(Right& right) {
  if (right->edge_count() == 0) return {};
  const Rational factor = 1 + Rational(1, 1'000'000);
  Broken result = with_all(right, [&](const Point& p) {
    return Point{factor * p.x, factor * p.y};
  });
  // Where a vertex comes to lie nearer to another one, that one would be taken for it.
  const auto off = [&](const Point& p) {
    return squared_distance(p, {factor * p.x, factor * p.y});
  };
  for (const Point& p : right->vertices) {
    if (off(p) >= right.small() * right.small()) return {};
  }
  result.names = {kMoved};
  return result;
}

std::optional<Broken> shift(Right& right) {
  if (right->vertices.empty()) return {};
  const Point step = right.small_step();
  Broken result = with_all(right, [&](const Point& p) {
    return Point{p.x + step.x, p.y + step.y};
  });
  result.tolerance = tolerance(right);
  result.names = {kMoved};
  return result;
}

std::optional<Broken> mirror(Right& right) {
  if (right->cycles.size() < 2 || right->face_count() < 2) return {};
  Broken result = with_all(right, [](const Point& p) { return Point{-p.x, p.y}; });
  for (std::size_t v = 0; v < right->vertices.size(); ++v) {
    result.places.push_back({-right.point(VertexId(v)).x, right.point(VertexId(v)).y});
  }
  result.names = {broken(Invariant::Orientation)};
  result.groups = right->vertices.size();  // parts that are their own mirror images are right
  return result;
}

std::optional<Broken> exchange_coordinates(Right& right) {
  const VertexId v = right.vertex([&](VertexId i) {
    const Point p = right.point(i), q{p.y, p.x};
    const auto is_near = [&](const Point& other) {
      return squared_distance(q, other) <= right.small() * right.small();
    };
    return !right.neighbours(i).empty() &&
           std::none_of(right->vertices.begin(), right->vertices.end(), is_near);
  });
  if (!v.valid()) return {};
  return with_vertex_at(right, v, {right.point(v).y, right.point(v).x});
}

}  // namespace

const std::vector<Mutation>& of_places() {
  static const std::vector<Mutation> list{
      {"move a vertex a little", move_a_little},
      {"move a vertex a lot", move_a_lot},
      {"move a vertex onto an edge", move_onto_edge},
      {"move a vertex onto another", move_onto_vertex},
      {"exchange two vertices", exchange_vertices},
      {"scale by 1.000001", scale},
      {"shift everything", shift},
      {"mirror everything", mirror},
      {"exchange the coordinates of a vertex", exchange_coordinates},
  };
  return list;
}

}  // namespace plumbline::mutations

// Cycles, faces and holes that are wrong; vertices and edges stay as they were, but for one edge's
// direction.

#include <algorithm>
#include <iterator>

#include "mutations/mutations.hpp"

namespace plumbline::mutations {
namespace {

using Walk = std::vector<HalfedgeId>;

std::vector<Point> points_of(const Right& right, std::span<const HalfedgeId> walk) {
  std::vector<Point> result;
  for (const HalfedgeId h : walk) result.push_back(right.point(right->origin(h)));
  for (const HalfedgeId h : walk) result.push_back(right.point(right->target(h)));
  return result;
}

Walk turned_round(Walk walk) {
  std::reverse(walk.begin(), walk.end());
  for (HalfedgeId& h : walk) h = twin(h);
  return walk;
}

FaceId any_bounded(Right& right) {
  return right.bounded_face([](FaceId) { return true; });
}

std::optional<Broken> flip_cycle(Right& right) {
  const FaceId f = any_bounded(right);
  if (!f.valid()) return {};
  Parts parts(*right);
  Walk& cycle = parts.cycles[parts.outer[f]];
  cycle = turned_round(cycle);
  return Broken{parts.complex(),
                0,
                {broken(Invariant::Orientation), broken(Invariant::HalfedgeInCycle)},
                points_of(right, cycle)};
}

std::optional<Broken> reverse_edge(Right& right) {
  const EdgeId e = right.edge([](EdgeId) { return true; });
  if (!e.valid()) return {};
  Parts parts(*right);
  std::swap(parts.edges[e].tail, parts.edges[e].head);
  Broken result{parts.complex(), 0, {broken(Invariant::CycleClosed)}, ends(right, e)};
  // An edge on its own is a cycle in either direction.
  const bool is_alone = right.neighbours(right->edges[e].tail).size() == 1 &&
                        right.neighbours(right->edges[e].head).size() == 1;
  if (is_alone) return {};
  return result;
}

std::optional<Broken> open_cycle(Right& right) {
  const CycleId c = right.any<CycleId>(right->cycles.size(),
                                       [&](CycleId i) { return right->cycles[i].size() > 2; });
  if (!c.valid()) return {};
  Parts parts(*right);
  Walk& cycle = parts.cycles[c];
  const auto at = cycle.begin() + static_cast<std::ptrdiff_t>(right.below(cycle.size()));
  const HalfedgeId h = *at;
  cycle.erase(at);
  return Broken{parts.complex(),
                0,
                {broken(Invariant::CycleClosed), broken(Invariant::HalfedgeInCycle),
                 broken(Invariant::BoundaryOfBoundary)},
                ends(right, edge_of(h))};
}

std::optional<Broken> drop_face(Right& right) {
  const FaceId f = any_bounded(right);
  if (!f.valid()) return {};
  Parts parts(*right);
  std::vector<bool> is_dropped(parts.cycles.size());
  is_dropped[parts.outer[f]] = true;
  for (const CycleId hole : parts.holes[f]) is_dropped[hole] = true;
  const Walk cycle = parts.cycles[parts.outer[f]];
  parts.drop_cycles(is_dropped);
  return Broken{parts.complex(),
                0,
                {broken(Invariant::HalfedgeInCycle),
                 broken(Invariant::Area),
                 {CellKind::Face, Disagreement::Missing}},
                points_of(right, cycle)};
}

std::optional<Broken> drop_all_faces(Right& right) {
  if (right->face_count() < 2) return {};
  Parts parts(*right);
  parts.drop_cycles(std::vector<bool>(parts.cycles.size(), true));
  return Broken{parts.complex(),
                0,
                {broken(Invariant::HalfedgeInCycle), {CellKind::Face, Disagreement::Missing}},
                {right->vertices.begin(), right->vertices.end()}};
}

std::optional<Broken> repeat_face(Right& right) {
  const FaceId f = any_bounded(right);
  if (!f.valid()) return {};
  Parts parts(*right);
  parts.cycles.push_back(parts.cycles[parts.outer[f]]);
  parts.outer.emplace_back(parts.cycles.size() - 1);
  parts.holes.emplace_back();
  parts.isolated.emplace_back();
  return Broken{parts.complex(),
                0,
                {broken(Invariant::HalfedgeInCycle), broken(Invariant::Area)},
                points_of(right, parts.cycles.back())};
}

/// A face that claims its neighbour as well.
std::optional<Broken> spread_face(Right& right) {
  const EdgeId e = right.edge([&](EdgeId i) {
    const HalfedgeId h = halfedge(i, false);
    const auto is_outer = [&](HalfedgeId g) {
      const FaceId f = right->halfedge_face[g];
      if (f == kUnbounded) return false;
      const auto cycle = right->cycles[right->face_outer[f]];
      return std::find(cycle.begin(), cycle.end(), g) != cycle.end();
    };
    return !right->is_antenna(i) && is_outer(h) && is_outer(twin(h));
  });
  if (!e.valid()) return {};
  const HalfedgeId h = halfedge(e, false);
  const FaceId f = right->halfedge_face[h], g = right->halfedge_face[twin(h)];
  Parts parts(*right);
  Walk &here = parts.cycles[parts.outer[f]], there = parts.cycles[parts.outer[g]];
  std::rotate(here.begin(), std::find(here.begin(), here.end(), h), here.end());
  std::rotate(there.begin(), std::find(there.begin(), there.end(), twin(h)), there.end());
  here.erase(here.begin());
  here.insert(here.end(), there.begin() + 1, there.end());
  return Broken{parts.complex(),
                0,
                {broken(Invariant::HalfedgeInCycle), broken(Invariant::Area)},
                points_of(right, here)};
}

/// A hole in another face.
std::optional<Broken> reparent_hole(Right& right) {
  const FaceId from = right.any<FaceId>(right->face_count(),
                                        [&](FaceId f) { return !right->face_holes[f].empty(); });
  if (!from.valid()) return {};
  Parts parts(*right);
  const std::size_t i = right.below(parts.holes[from].size());
  const CycleId hole = parts.holes[from][i];
  // Not into a face of the hole's own component, which would be no wrong parent but nonsense.
  const ComponentId k = right->vertex_component[right->origin(right->cycles[hole].front())];
  const FaceId to = right.any<FaceId>(right->face_count(), [&](FaceId f) {
    if (f == from || f == kUnbounded) return f != from;
    const auto cycle = right->cycles[right->face_outer[f]];
    return right->vertex_component[right->origin(cycle.front())] != k;
  });
  if (!to.valid()) return {};
  parts.holes[from].erase(parts.holes[from].begin() + static_cast<std::ptrdiff_t>(i));
  parts.holes[to].push_back(hole);
  return Broken{parts.complex(),
                0,
                {broken(Invariant::Nesting), {CellKind::Hole, Disagreement::WrongParent}},
                points_of(right, parts.cycles[hole])};
}

std::optional<Broken> reparent_vertex(Right& right) {
  const FaceId from = right.any<FaceId>(
      right->face_count(), [&](FaceId f) { return !right->face_isolated_vertices[f].empty(); });
  const FaceId to = right.any<FaceId>(right->face_count(), [&](FaceId f) { return f != from; });
  if (!from.valid() || !to.valid()) return {};
  Parts parts(*right);
  const VertexId v = parts.isolated[from].back();
  parts.isolated[from].pop_back();
  parts.isolated[to].push_back(v);
  return Broken{parts.complex(),
                0,
                {broken(Invariant::Nesting), {CellKind::Vertex, Disagreement::WrongParent}},
                {right.point(v)}};
}

std::optional<Broken> drop_hole(Right& right) {
  const FaceId f = right.bounded_face([&](FaceId g) { return !right->face_holes[g].empty(); });
  if (!f.valid()) return {};
  Parts parts(*right);
  const CycleId hole = parts.holes[f].back();
  parts.holes[f].pop_back();
  return Broken{parts.complex(),
                0,
                {broken(Invariant::HalfedgeInCycle), {CellKind::Hole, Disagreement::Missing}},
                points_of(right, parts.cycles[hole])};
}

/// A vertex of no edge that no face knows of.
std::optional<Broken> forget_vertex(Right& right) {
  const FaceId f = right.any<FaceId>(
      right->face_count(), [&](FaceId g) { return !right->face_isolated_vertices[g].empty(); });
  if (!f.valid()) return {};
  Parts parts(*right);
  const VertexId v = parts.isolated[f].back();
  parts.isolated[f].pop_back();
  return Broken{parts.complex(), 0, {broken(Invariant::Nesting)}, {right.point(v)}};
}

std::optional<Broken> exchange_outer_and_hole(Right& right) {
  const FaceId f = right.bounded_face([&](FaceId g) { return !right->face_holes[g].empty(); });
  if (!f.valid()) return {};
  Parts parts(*right);
  std::swap(parts.outer[f], parts.holes[f].front());
  return Broken{parts.complex(),
                0,
                {broken(Invariant::Orientation)},
                points_of(right, parts.cycles[parts.holes[f].front()])};
}

/// Two faces with each other's holes.
std::optional<Broken> exchange_holes(Right& right) {
  const FaceId f = right.bounded_face([&](FaceId g) { return !right->face_holes[g].empty(); });
  const FaceId g = right.bounded_face([&](FaceId i) {
    const auto component = [&](FaceId j) {
      const auto cycle = right->cycles[right->face_outer[j]];
      return right->vertex_component[right->origin(cycle.front())];
    };
    if (!f.valid() || i == f) return false;
    for (const CycleId hole : right->face_holes[f]) {
      if (right->vertex_component[right->origin(right->cycles[hole].front())] == component(i)) {
        return false;
      }
    }
    for (const CycleId hole : right->face_holes[i]) {
      if (right->vertex_component[right->origin(right->cycles[hole].front())] == component(f)) {
        return false;
      }
    }
    return true;
  });
  if (!g.valid()) return {};
  Parts parts(*right);
  const Walk hole = parts.cycles[parts.holes[f].front()];
  std::swap(parts.holes[f], parts.holes[g]);
  return Broken{parts.complex(),
                0,
                {broken(Invariant::Nesting), {CellKind::Hole, Disagreement::WrongParent}},
                points_of(right, hole)};
}

/// Two cycles, or one, that take each other's way at a vertex.
std::optional<Broken> turn_wrongly(Right& right) {
  const VertexId v = right.vertex([&](VertexId i) { return right.neighbours(i).size() >= 3; });
  if (!v.valid()) return {};
  // Where each halfedge goes on; two that arrive at v are exchanged, and cycles walked anew.
  std::vector<HalfedgeId> next(2 * right->edge_count());
  for (std::size_t c = 0; c < right->cycles.size(); ++c) {
    const auto cycle = right->cycles[c];
    for (std::size_t i = 0; i < cycle.size(); ++i) next[cycle[i]] = cycle[(i + 1) % cycle.size()];
  }
  std::vector<HalfedgeId> arriving;
  for (std::size_t h = 0; h < next.size(); ++h) {
    if (right->target(HalfedgeId(h)) == v) arriving.emplace_back(h);
  }
  std::swap(next[arriving[0]], next[arriving[1]]);
  Parts parts(*right);
  parts.cycles.clear();
  std::vector<bool> is_seen(next.size());
  for (std::size_t h = 0; h < next.size(); ++h) {
    if (is_seen[h]) continue;
    Walk walk;
    for (HalfedgeId g(h); !is_seen[g]; g = next[g]) {
      is_seen[g] = true;
      walk.push_back(g);
    }
    parts.cycles.push_back(walk);
  }
  // Each cycle is an outer boundary: of which face is not what this is about.
  parts.outer.assign(1, CycleId());
  parts.holes.assign(1, {});
  for (std::size_t c = 0; c < parts.cycles.size(); ++c) {
    parts.outer.emplace_back(c);
    parts.holes.emplace_back();
  }
  parts.isolated.resize(parts.outer.size());
  return Broken{parts.complex(), 0, {broken(Invariant::CyclicOrder)}, {right.point(v)}};
}

}  // namespace

const std::vector<Mutation>& of_incidences() {
  static const std::vector<Mutation> list{
      {"flip a cycle", flip_cycle},
      {"reverse an edge", reverse_edge},
      {"open a cycle", open_cycle},
      {"drop a face", drop_face},
      {"drop all faces", drop_all_faces},
      {"repeat a face", repeat_face},
      {"spread a face over its neighbour", spread_face},
      {"reparent a hole", reparent_hole},
      {"reparent an isolated vertex", reparent_vertex},
      {"drop a hole", drop_hole},
      {"forget an isolated vertex", forget_vertex},
      {"exchange outer boundary and hole", exchange_outer_and_hole},
      {"exchange the holes of two faces", exchange_holes},
      {"turn wrongly at a vertex", turn_wrongly},
  };
  return list;
}

}  // namespace plumbline::mutations

// What goes in is a graph in the plane and faces that claim some of its halfedges. The true cycles
// of the graph are walked by angle; what nobody claims on a cycle is an antenna of the face that
// claims the rest of it; a cycle that nobody claims at all is the outline of a component, whose
// place decides whom it belongs to, or encloses a gap.

#include "engine/complete_boundaries.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "complex/active_edges.hpp"
#include "complex/direction.hpp"

namespace plumbline {
namespace {

using Cycle = std::vector<HalfedgeId>;

/// Per halfedge the one after it on the boundary that it is part of: the next one clockwise from
/// its twin. Degenerate: halfedges in the same direction go by index.
std::vector<HalfedgeId> clockwise_successors(const ExactComplex& c) {
  std::vector<std::vector<std::pair<Direction, HalfedgeId>>> around(c.vertices.size());
  for (std::size_t i = 0; i < 2 * c.edge_count(); ++i) {
    const HalfedgeId h(i);
    around[c.origin(h)].emplace_back(Direction(c.vertices[c.origin(h)], c.vertices[c.target(h)]),
                                     h);
  }
  std::vector<HalfedgeId> next(2 * c.edge_count());
  for (auto& leaving : around) {
    std::sort(leaving.begin(), leaving.end());
    for (std::size_t k = 0; k < leaving.size(); ++k) {
      next[twin(leaving[k].second)] = leaving[(k + leaving.size() - 1) % leaving.size()].second;
    }
  }
  return next;
}

/// The orbits of a permutation of the halfedges.
std::vector<Cycle> walks(const std::vector<HalfedgeId>& next) {
  std::vector<Cycle> result;
  std::vector<bool> seen(next.size());
  for (std::size_t first = 0; first < next.size(); ++first) {
    if (seen[first]) continue;
    Cycle& walk = result.emplace_back();
    for (HalfedgeId h(first); !seen[h]; h = next[h]) {
      seen[h] = true;
      walk.push_back(h);
    }
  }
  return result;
}

/// What is given, as a graph in the plane with its true cycles.
struct Graph {
  ExactComplex exact;
  std::vector<HalfedgeId> next;      ///< per halfedge, along its walk
  std::vector<Cycle> walks;          ///< the true cycles
  std::vector<std::size_t> walk_of;  ///< per halfedge

  bool is_tree(const Cycle& walk) const {
    return std::all_of(walk.begin(), walk.end(),
                       [&](HalfedgeId h) { return walk_of[twin(h)] == walk_of[h]; });
  }
  Rational twice_area(const Cycle& cycle) const {
    Rational sum = 0;
    for (const HalfedgeId h : cycle) {
      const Point &p = exact.vertices[exact.origin(h)], &q = exact.vertices[exact.target(h)];
      sum += p.x * q.y - q.x * p.y;
    }
    return sum;
  }
};

Graph graph_of(const FloatComplex& given) {
  Graph graph;
  graph.exact = exact(given);
  graph.next = clockwise_successors(graph.exact);
  graph.walks = walks(graph.next);
  graph.walk_of.resize(graph.next.size());
  for (std::size_t i = 0; i < graph.walks.size(); ++i) {
    for (const HalfedgeId h : graph.walks[i]) graph.walk_of[h] = i;
  }
  return graph;
}

struct Claims {
  std::vector<FaceId> face;     ///< per halfedge: the face that claims it, the last of several
  std::vector<Cycle> boundary;  ///< per face all that it claims
};

Claims claims_of(const FloatComplex& given) {
  Claims claims{std::vector<FaceId>(2 * given.edge_count()),
                std::vector<Cycle>(given.face_count())};
  const auto claim = [&](FaceId f, CycleId cycle) {
    for (const HalfedgeId h : given.cycles[cycle]) {
      claims.face[h] = f;
      claims.boundary[f].push_back(h);
    }
  };
  for (std::size_t f = 1; f < given.face_count(); ++f) {
    claim(FaceId(f), given.face_outer[f]);
    for (const CycleId hole : given.face_holes[f]) claim(FaceId(f), hole);
  }
  return claims;
}

/// The faces that claim halfedges of the walk, ascending, each once.
std::vector<FaceId> claimers_of(const Cycle& walk, const Claims& claims) {
  std::vector<FaceId> claimers;
  for (const HalfedgeId h : walk) {
    const FaceId f = claims.face[h];
    if (f.valid() && (claimers.empty() || claimers.back() != f)) claimers.push_back(f);
  }
  std::sort(claimers.begin(), claimers.end());
  claimers.erase(std::unique(claimers.begin(), claimers.end()), claimers.end());
  return claimers;
}

/// The walks that nobody claims any of.
std::vector<std::size_t> open_walks(const Graph& graph, const Claims& claims) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < graph.walks.size(); ++i) {
    if (claimers_of(graph.walks[i], claims).empty()) open.push_back(i);
  }
  return open;
}

/// Where one face claims a walk but for antennas, it is given the antennas; what nobody claims of
/// other walks stays so.
Claims with_antennas(const Graph& graph, Claims claims) {
  for (std::size_t i = 0; i < graph.walks.size(); ++i) {
    const std::vector<FaceId> claimers = claimers_of(graph.walks[i], claims);
    if (claimers.size() != 1) continue;
    Cycle unclaimed;
    for (const HalfedgeId h : graph.walks[i]) {
      if (!claims.face[h].valid()) unclaimed.push_back(h);
    }
    const bool are_antennas = std::all_of(unclaimed.begin(), unclaimed.end(), [&](HalfedgeId h) {
      return graph.walk_of[twin(h)] == i && !claims.face[twin(h)].valid();
    });
    if (!are_antennas) continue;
    for (const HalfedgeId h : unclaimed) {
      claims.boundary[claimers.front()].push_back(h);
      claims.face[h] = claimers.front();
    }
  }
  return claims;
}

/// Per component the open walks around it.
std::vector<std::vector<std::size_t>> outlines_of(const Graph& graph,
                                                  const std::vector<std::size_t>& open) {
  std::vector<std::vector<std::size_t>> outlines(graph.exact.component_count());
  for (const std::size_t i : open) {
    const Cycle& walk = graph.walks[i];
    if (!graph.is_tree(walk) && graph.twice_area(walk) > 0) continue;  // a gap
    outlines[graph.exact.vertex_component[graph.exact.origin(walk.front())]].push_back(i);
  }
  return outlines;
}

/// What lies in each face that nobody claims.
struct Inside {
  std::vector<std::vector<std::size_t>> holes;  ///< per face: walks
  std::vector<std::vector<VertexId>> isolated;  ///< per face
};

/// Components come by their least vertices, so what is below the next one has been placed.
Inside placed_components(const Graph& graph, const Claims& claims,
                         const std::vector<std::size_t>& open) {
  const ExactComplex& c = graph.exact;
  const std::vector<std::vector<std::size_t>> outlines = outlines_of(graph, open);
  Inside inside;
  inside.holes.resize(claims.boundary.size());
  inside.isolated.resize(claims.boundary.size());
  // Per open walk the face that it lies in; invalid: a gap.
  std::vector<FaceId> around(graph.walks.size());
  std::vector<bool> has_edge(c.vertices.size());
  for (const Edge& e : c.edges) has_edge[e.tail] = has_edge[e.head] = true;
  ActiveEdges edges(c);
  const std::vector<VertexId> least = least_vertices(c);
  for (std::size_t k = 0; k < least.size(); ++k) {
    if (has_edge[least[k]] && outlines[k].empty()) continue;
    edges.advance(c.vertices[least[k]].x);
    const std::optional<EdgeId> below = edges.below(least[k]);
    FaceId face = kUnbounded;
    if (below) {
      const HalfedgeId h = halfedge(*below, false);
      face = claims.face[h].valid() ? claims.face[h] : around[graph.walk_of[h]];
    }
    if (!has_edge[least[k]] && face.valid()) inside.isolated[face].push_back(least[k]);
    for (const std::size_t walk : outlines[k]) {
      around[walk] = face;
      const bool is_hole = face == kUnbounded || (face.valid() && graph.is_tree(graph.walks[walk]));
      if (is_hole) inside.holes[face].push_back(walk);
    }
  }
  return inside;
}

/// The cycles of all that a face claims, the outer one first; none where that is no boundary of
/// one piece.
std::optional<std::vector<Cycle>> relinked(const Graph& graph, const Cycle& boundary) {
  std::vector<HalfedgeId> sorted = boundary;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return std::nullopt;
  const auto position = [&](HalfedgeId h) {
    const auto found = std::lower_bound(sorted.begin(), sorted.end(), h);
    return found != sorted.end() && *found == h ? static_cast<std::size_t>(found - sorted.begin())
                                                : sorted.size();
  };
  const auto successor = [&](HalfedgeId h) {
    const HalfedgeId first = graph.next[h];
    for (HalfedgeId x = first;;) {
      if (const std::size_t i = position(x); i < sorted.size()) return i;
      x = graph.next[twin(x)];
      if (x == first) return sorted.size();  // the walk ends here
    }
  };
  std::vector<Cycle> cycles;
  std::vector<bool> seen(sorted.size());
  std::size_t outer_count = 0;
  for (const HalfedgeId start : boundary) {
    const std::size_t first = position(start);
    if (seen[first]) continue;
    Cycle cycle;
    std::size_t i = first;
    do {
      if (i == sorted.size() || seen[i]) return std::nullopt;
      seen[i] = true;
      cycle.push_back(sorted[i]);
      i = successor(sorted[i]);
    } while (i != first);
    if (graph.twice_area(cycle) > 0) {
      ++outer_count;
      cycles.insert(cycles.begin(), std::move(cycle));
    } else {
      cycles.push_back(std::move(cycle));
    }
  }
  if (outer_count != 1) return std::nullopt;
  return cycles;
}

FloatComplex completed(const FloatComplex& given, const Graph& graph, const Claims& claims,
                       const std::vector<std::size_t>& open, const Inside& inside) {
  FloatComplex c;
  c.vertices = given.vertices;
  c.edges = given.edges;
  c.edge_sources = given.edge_sources;
  const auto add_cycle = [&](const auto& cycle) {
    c.cycles.push_back(cycle);
    return CycleId(c.cycles.size() - 1);
  };
  std::vector<bool> is_placed(graph.walks.size());
  for (std::size_t i = 0; i < given.face_count(); ++i) {
    const FaceId f(i);
    CycleId outer;
    std::vector<CycleId> holes;
    if (const auto cycles = f == kUnbounded ? std::nullopt : relinked(graph, claims.boundary[f])) {
      outer = add_cycle(cycles->front());
      for (std::size_t k = 1; k < cycles->size(); ++k) holes.push_back(add_cycle((*cycles)[k]));
    } else if (f != kUnbounded) {
      outer = add_cycle(given.cycles[given.face_outer[f]]);
      for (const CycleId hole : given.face_holes[f]) holes.push_back(add_cycle(given.cycles[hole]));
    }
    for (const std::size_t walk : inside.holes[f]) {
      holes.push_back(add_cycle(graph.walks[walk]));
      is_placed[walk] = true;
    }
    c.face_outer.push_back(outer);
    c.face_holes.push_back(holes);
    c.face_isolated_vertices.push_back(inside.isolated[f]);
  }
  for (const std::size_t walk : open) {
    if (!is_placed[walk]) add_cycle(graph.walks[walk]);
  }
  return c;
}

}  // namespace

FloatComplex complete_boundaries(const FloatComplex& complex) {
  const Graph graph = graph_of(complex);
  const Claims claims = with_antennas(graph, claims_of(complex));
  const std::vector<std::size_t> open = open_walks(graph, claims);
  const Inside inside = placed_components(graph, claims, open);
  return completed(complex, graph, claims, open, inside);
}

}  // namespace plumbline

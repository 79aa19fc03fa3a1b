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

class Completion {
 public:
  explicit Completion(const FloatComplex& given)
      : given_(given),
        exact_(exact(given)),
        next_(clockwise_successors(exact_)),
        walks_(walks(next_)),
        walk_of_(next_.size()),
        face_(next_.size()),
        boundary_(given.face_count()),
        extra_holes_(given.face_count()),
        isolated_(given.face_count()),
        around_(walks_.size()) {
    for (std::size_t i = 0; i < walks_.size(); ++i) {
      for (const HalfedgeId h : walks_[i]) walk_of_[h] = i;
    }
  }

  FloatComplex run() {
    take_claims();
    for (std::size_t i = 0; i < walks_.size(); ++i) settle(i);
    place_components();
    return result();
  }

 private:
  void take_claims();
  void settle(std::size_t walk);
  void place_components();
  bool is_tree(const Cycle& walk) const;
  Rational twice_area(const Cycle& cycle) const;
  std::optional<std::vector<Cycle>> relinked(FaceId f) const;
  FloatComplex result() const;

  const FloatComplex& given_;
  const ExactComplex exact_;
  const std::vector<HalfedgeId> next_;
  const std::vector<Cycle> walks_;
  std::vector<std::size_t> walk_of_;  ///< per halfedge
  std::vector<FaceId> face_;     ///< per halfedge: the face that claims it, the last of several
  std::vector<Cycle> boundary_;  ///< per face all that it claims, antennas too
  std::vector<std::vector<std::size_t>> extra_holes_;  ///< per face: walks
  std::vector<std::vector<VertexId>> isolated_;        ///< per face
  std::vector<std::size_t> open_;                      ///< walks that nobody claims any of
  std::vector<FaceId> around_;  ///< per open walk the face that it lies in; invalid: a gap
};

void Completion::take_claims() {
  const auto claim = [&](FaceId f, CycleId cycle) {
    for (const HalfedgeId h : given_.cycles[cycle]) {
      face_[h] = f;
      boundary_[f].push_back(h);
    }
  };
  for (std::size_t f = 1; f < given_.face_count(); ++f) {
    claim(FaceId(f), given_.face_outer[f]);
    for (const CycleId hole : given_.face_holes[f]) claim(FaceId(f), hole);
  }
}

/// A walk is open, or one face claims it but for antennas, which the face is given; else what
/// nobody claims of it stays so.
void Completion::settle(std::size_t walk) {
  std::vector<FaceId> claimers;
  Cycle unclaimed;
  for (const HalfedgeId h : walks_[walk]) {
    if (!face_[h].valid())
      unclaimed.push_back(h);
    else if (claimers.empty() || claimers.back() != face_[h])
      claimers.push_back(face_[h]);
  }
  if (claimers.empty()) return open_.push_back(walk);
  std::sort(claimers.begin(), claimers.end());
  if (claimers.front() != claimers.back()) return;
  const bool are_antennas = std::all_of(unclaimed.begin(), unclaimed.end(), [&](HalfedgeId h) {
    return walk_of_[twin(h)] == walk && !face_[twin(h)].valid();
  });
  if (!are_antennas) return;
  for (const HalfedgeId h : unclaimed) boundary_[claimers.front()].push_back(h);
  for (const HalfedgeId h : unclaimed) face_[h] = claimers.front();
}

bool Completion::is_tree(const Cycle& walk) const {
  return std::all_of(walk.begin(), walk.end(),
                     [&](HalfedgeId h) { return walk_of_[twin(h)] == walk_of_[h]; });
}

Rational Completion::twice_area(const Cycle& cycle) const {
  Rational sum = 0;
  for (const HalfedgeId h : cycle) {
    const Point &p = exact_.vertices[exact_.origin(h)], &q = exact_.vertices[exact_.target(h)];
    sum += p.x * q.y - q.x * p.y;
  }
  return sum;
}

/// Components come by their least vertices, so what is below the next one has been placed.
void Completion::place_components() {
  std::vector<std::vector<std::size_t>> outlines(exact_.component_count());
  for (const std::size_t walk : open_) {
    if (!is_tree(walks_[walk]) && twice_area(walks_[walk]) > 0) continue;  // a gap
    outlines[exact_.vertex_component[exact_.origin(walks_[walk].front())]].push_back(walk);
  }
  std::vector<bool> has_edge(exact_.vertices.size());
  for (const Edge& e : exact_.edges) has_edge[e.tail] = has_edge[e.head] = true;
  ActiveEdges edges(exact_);
  const std::vector<VertexId> least = least_vertices(exact_);
  for (std::size_t k = 0; k < least.size(); ++k) {
    if (has_edge[least[k]] && outlines[k].empty()) continue;
    edges.advance(exact_.vertices[least[k]].x);
    const std::optional<EdgeId> below = edges.below(least[k]);
    FaceId face = kUnbounded;
    if (below) {
      const HalfedgeId h = halfedge(*below, false);
      face = face_[h].valid() ? face_[h] : around_[walk_of_[h]];
    }
    if (!has_edge[least[k]] && face.valid()) isolated_[face].push_back(least[k]);
    for (const std::size_t walk : outlines[k]) {
      around_[walk] = face;
      const bool is_hole = face == kUnbounded || (face.valid() && is_tree(walks_[walk]));
      if (is_hole) extra_holes_[face].push_back(walk);
    }
  }
}

/// The cycles of all that the face claims, the outer one first; none where that is no boundary of
/// one piece.
std::optional<std::vector<Cycle>> Completion::relinked(FaceId f) const {
  const Cycle& boundary = boundary_[f];
  std::vector<HalfedgeId> sorted = boundary;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return std::nullopt;
  const auto position = [&](HalfedgeId h) {
    const auto found = std::lower_bound(sorted.begin(), sorted.end(), h);
    return found != sorted.end() && *found == h ? static_cast<std::size_t>(found - sorted.begin())
                                                : sorted.size();
  };
  const auto successor = [&](HalfedgeId h) {
    const HalfedgeId first = next_[h];
    for (HalfedgeId x = first;;) {
      if (const std::size_t i = position(x); i < sorted.size()) return i;
      x = next_[twin(x)];
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
    if (twice_area(cycle) > 0) {
      ++outer_count;
      cycles.insert(cycles.begin(), std::move(cycle));
    } else {
      cycles.push_back(std::move(cycle));
    }
  }
  if (outer_count != 1) return std::nullopt;
  return cycles;
}

FloatComplex Completion::result() const {
  FloatComplex c;
  c.vertices = given_.vertices;
  c.edges = given_.edges;
  c.edge_sources = given_.edge_sources;
  const auto add_cycle = [&](const auto& cycle) {
    c.cycles.push_back(cycle);
    return CycleId(c.cycles.size() - 1);
  };
  std::vector<bool> is_placed(walks_.size());
  for (std::size_t i = 0; i < given_.face_count(); ++i) {
    const FaceId f(i);
    CycleId outer;
    std::vector<CycleId> holes;
    if (const auto cycles = f == kUnbounded ? std::nullopt : relinked(f)) {
      outer = add_cycle(cycles->front());
      for (std::size_t k = 1; k < cycles->size(); ++k) holes.push_back(add_cycle((*cycles)[k]));
    } else if (f != kUnbounded) {
      outer = add_cycle(given_.cycles[given_.face_outer[f]]);
      for (const CycleId hole : given_.face_holes[f])
        holes.push_back(add_cycle(given_.cycles[hole]));
    }
    for (const std::size_t walk : extra_holes_[f]) {
      holes.push_back(add_cycle(walks_[walk]));
      is_placed[walk] = true;
    }
    c.face_outer.push_back(outer);
    c.face_holes.push_back(holes);
    c.face_isolated_vertices.push_back(isolated_[f]);
  }
  for (const std::size_t walk : open_) {
    if (!is_placed[walk]) add_cycle(walks_[walk]);
  }
  return c;
}

}  // namespace

FloatComplex complete_boundaries(const FloatComplex& complex) { return Completion(complex).run(); }

}  // namespace plumbline

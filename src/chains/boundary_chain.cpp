// Boundaries of chains of faces. The walk along a boundary turns, at a vertex, through the chain's
// own faces, so that cycles that touch in a vertex stay apart.

#include "plumbline/chains.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

std::vector<bool> members(const Incidences& complex, std::span<const FaceId> chain) {
  std::vector<bool> is_member(complex.face_count(), false);
  for (const FaceId f : chain) {
    if (f >= complex.face_count()) {
      throw Error(ErrorCode::BadInput, "a chain of faces has a face that the complex has not", {},
                  std::to_string(std::size_t{f}));
    }
    is_member[f] = true;
  }
  return is_member;
}

std::vector<HalfedgeId> next_on_face(const Incidences& complex) {
  std::vector<HalfedgeId> next(2 * complex.edge_count());
  for (std::size_t c = 0; c < complex.cycles.size(); ++c) {
    const auto cycle = complex.cycles[c];
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      next[cycle[i]] = cycle[i + 1 == cycle.size() ? 0 : i + 1];
    }
  }
  return next;
}

}  // namespace

std::vector<HalfedgeId> boundary_chain(const Incidences& complex, std::span<const FaceId> chain) {
  const std::vector<bool> is_member = members(complex, chain);
  std::vector<HalfedgeId> boundary;
  for (std::size_t i = 0; i < 2 * complex.edge_count(); ++i) {
    const HalfedgeId h(i);
    const bool is_left = is_member[complex.halfedge_face[h]];
    if (is_left && !is_member[complex.halfedge_face[twin(h)]]) boundary.push_back(h);
  }
  return boundary;
}

Lists<HalfedgeId> boundary_cycles(const Incidences& complex, std::span<const FaceId> chain) {
  const std::vector<HalfedgeId> boundary = boundary_chain(complex, chain);
  const std::vector<HalfedgeId> next = next_on_face(complex);
  std::vector<bool> is_left(next.size(), false);
  for (const HalfedgeId h : boundary) is_left[h] = true;
  Lists<HalfedgeId> cycles;
  std::vector<HalfedgeId> cycle;
  for (const HalfedgeId start : boundary) {
    cycle.clear();
    for (HalfedgeId h = start; is_left[h];) {
      is_left[h] = false;
      cycle.push_back(h);
      h = next[h];
      // Inside the chain until an edge bounds it again; the start bounds it, though it is done.
      while (!is_left[h] && h != start) h = next[twin(h)];
    }
    if (!cycle.empty()) cycles.push_back(cycle);
  }
  return cycles;
}

std::vector<std::vector<PointD>> boundary_polylines(const FloatComplex& complex,
                                                    std::span<const FaceId> chain) {
  std::vector<std::vector<PointD>> polylines;
  const Lists<HalfedgeId> cycles = boundary_cycles(complex, chain);
  for (std::size_t c = 0; c < cycles.size(); ++c) {
    polylines.emplace_back();
    for (const HalfedgeId h : cycles[c]) {
      polylines.back().push_back(complex.vertices[complex.origin(h)]);
    }
    polylines.back().push_back(polylines.back().front());
  }
  return polylines;
}

}  // namespace plumbline

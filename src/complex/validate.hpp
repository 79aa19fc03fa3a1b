#pragma once

#include <optional>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {

/// Collects violations, at most kMaxViolations of each kind.
class Violations {
 public:
  void add(Violation violation);
  bool has(Invariant invariant) const { return counts_[static_cast<std::size_t>(invariant)] != 0; }
  bool empty() const { return list_.empty(); }
  std::vector<Violation> take() { return std::move(list_); }

 private:
  static constexpr std::size_t kKinds = static_cast<std::size_t>(Invariant::Coverage) + 1;
  std::size_t counts_[kKinds] = {};
  std::vector<Violation> list_;
};

/// Invariants of the incidences alone: Index, HalfedgeInCycle, CycleClosed, BoundaryOfBoundary,
/// Euler.
void validate_incidences(const ExactComplex& complex, Violations& violations);
/// Of these: which face claims which halfedge, and that the derived members say the same. Requires:
/// indices in range.
void validate_claims(const ExactComplex& complex, Violations& violations);
/// Invariants of the graph in the plane: DuplicateVertex, DuplicateEdge, VertexOnEdge, Crossing.
void validate_graph(const ExactComplex& complex, Violations& violations);
/// Invariants of the faces in the plane: Orientation, CyclicOrder, Area.
void validate_faces(const ExactComplex& complex, Violations& violations);
/// Nesting: each component lies in the face that its hole (or isolated vertex) belongs to.
/// `below` is what `edges_below_components` found. Requires: no violation of Derived.
void validate_nesting(const ExactComplex& complex,
                      const std::optional<std::vector<std::optional<EdgeId>>>& below,
                      Violations& violations);

/// Those three: what `is_certified` decides at once.
void validate_plane(const ExactComplex& complex, Violations& violations);

}  // namespace plumbline

#include "complex/validate.hpp"

#include <algorithm>
#include <utility>

#include "complex/planarity.hpp"

namespace plumbline {

std::string to_text(Invariant invariant) {
  switch (invariant) {
    case Invariant::Index:
      return "index";
    case Invariant::HalfedgeInCycle:
      return "halfedge in cycle";
    case Invariant::CycleClosed:
      return "cycle closed";
    case Invariant::Derived:
      return "derived member";
    case Invariant::BoundaryOfBoundary:
      return "boundary of boundary";
    case Invariant::Orientation:
      return "orientation";
    case Invariant::Crossing:
      return "crossing";
    case Invariant::VertexOnEdge:
      return "vertex on edge";
    case Invariant::DuplicateVertex:
      return "duplicate vertex";
    case Invariant::DuplicateEdge:
      return "duplicate edge";
    case Invariant::CyclicOrder:
      return "cyclic order";
    case Invariant::Nesting:
      return "nesting";
    case Invariant::Euler:
      return "euler";
    case Invariant::Area:
      return "area";
    case Invariant::Coverage:
      return "coverage";
  }
  return "unknown";
}

void Violations::add(Violation violation) {
  std::size_t& count = counts_[static_cast<std::size_t>(violation.invariant)];
  if (count++ < kMaxViolations) list_.push_back(std::move(violation));
}

void validate_plane(const ExactComplex& complex, Violations& violations) {
  const auto below = edges_below_components(complex);
  if (!below) validate_graph(complex, violations);
  validate_faces(complex, violations);
  if (!violations.has(Invariant::Derived)) validate_nesting(complex, below, violations);
}

std::vector<Violation> validate(const ExactComplex& complex) {
  Violations violations;
  validate_incidences(complex, violations);
  if (violations.empty() && is_certified(complex)) return {};
  if (!violations.has(Invariant::Index)) validate_plane(complex, violations);
  std::vector<Violation> list = violations.take();
  std::stable_sort(list.begin(), list.end(), [](const Violation& v, const Violation& w) {
    return v.invariant < w.invariant;
  });
  return list;
}

}  // namespace plumbline

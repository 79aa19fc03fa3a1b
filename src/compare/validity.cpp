// Question 1: is the float result, its doubles taken as exact, a valid complex at all?

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compare/steps.hpp"

namespace plumbline::compare_steps {
namespace {

template <class Id>
std::vector<std::size_t> numbers(const std::vector<Id>& ids) {
  return {ids.begin(), ids.end()};
}

/// The finding is about the edges, where the violation names some, else about vertices or faces.
Finding to_finding(const Sides& sides, const Violation& violation) {
  Finding finding;
  finding.disagreement = Disagreement::Invalid;
  finding.message = fmt::format("the float result is not a valid complex: {} ({})",
                                violation.message, to_text(violation.invariant));
  finding.invariant = violation.invariant;
  finding.where = violation.where;
  if (!violation.edges.empty()) {
    finding.kind = CellKind::Edge;
    finding.float_cells = numbers(violation.edges);
    finding.segments = segments_of(sides[Float], violation.edges);
  } else if (!violation.vertices.empty()) {
    finding.kind = CellKind::Vertex;
    finding.float_cells = numbers(violation.vertices);
    finding.segments = segments_at(sides, Float, violation.vertices);
  } else if (!violation.faces.empty()) {
    finding.kind = CellKind::Face;
    finding.float_cells = numbers(violation.faces);
  }
  return finding;
}

bool is_of_graph(Invariant invariant) {
  constexpr std::array kOfGraph = {Invariant::Index, Invariant::Crossing, Invariant::VertexOnEdge,
                                   Invariant::DuplicateVertex, Invariant::DuplicateEdge};
  return std::ranges::find(kOfGraph, invariant) != kOfGraph.end();
}

}  // namespace

std::vector<Finding> invalidities(const Sides& sides, Compared compared) {
  std::vector<Finding> findings;
  for (const Violation& violation : validate(sides[Float])) {
    if (compared == Compared::All || is_of_graph(violation.invariant)) {
      findings.push_back(to_finding(sides, violation));
    }
  }
  return findings;
}

}  // namespace plumbline::compare_steps

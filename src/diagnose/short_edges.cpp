// Short edges, except those of lines that are drawn in short edges.

#include <algorithm>

#include "diagnose/steps.hpp"

namespace plumbline::diagnose_steps {
namespace {

// An edge that goes on, without a branch, in one that is at most so many times as long is part of a
// finely drawn line, such as a curve in chords.
constexpr int kFine = 10;

bool is_finely_drawn(const LineGraph& graph, EdgeId e, const Rational& squared_length) {
  const Edge& edge = graph.complex().edges[e];
  const auto goes_on = [&](VertexId v) {
    return graph.degree(v) == 2 &&
           graph.squared_length(graph.next(e, v)) <= kFine * kFine * squared_length;
  };
  return goes_on(edge.tail) || goes_on(edge.head);
}

}  // namespace

Defects short_edges(const Subject& subject) {
  const LineGraph& graph = subject.graph;
  const ExactComplex& complex = graph.complex();
  Defects result(subject.most_listed);
  for (std::size_t i = 0; i < complex.edge_count(); ++i) {
    const EdgeId e(i);
    const Edge& edge = complex.edges[e];
    if (graph.is_tip(edge.tail) || graph.is_tip(edge.head)) continue;
    if (!graph.is_within(e, subject.within)) continue;
    Rational squared = graph.squared_length(e);
    if (is_finely_drawn(graph, e, squared)) continue;
    Defect defect;
    defect.kind = DefectKind::ShortEdge;
    defect.where = midpoint(complex.vertices[edge.tail], complex.vertices[edge.head]);
    defect.size = nearest_sqrt(squared);
    defect.proposed_tolerance = root_rounded_up(squared);
    defect.squared_size = std::move(squared);
    defect.vertices = {edge.tail, edge.head};
    defect.edges = {e};
    defect.segments = graph.segments(defect.edges);
    result.add(std::move(defect));
    result.add_accident(e);
  }
  return result;
}

}  // namespace plumbline::diagnose_steps

// Short edges that nobody drew: pieces of longer lines. The sides of a niche and what a line drawn
// in short edges is made of were drawn; the two sides of a wall that ends at another one leave a
// piece of that one between them.

#include <algorithm>

#include "diagnose/steps.hpp"

namespace plumbline::diagnose_steps {
namespace {

// An edge that goes on, without a branch, in one that is at most so many times as long is part of a
// finely drawn line, such as a curve in chords.
constexpr int kFine = 10;

// What leaves both ends of an edge in one direction and is so many times as long is a strip that
// the edge closes.
constexpr int kStrip = 4;
constexpr std::size_t kMostAtEnd = 8;  // edges where a strip ends

/// Whether it is a whole segment of the input, longer than what rounding could make of nothing.
bool is_drawn(const Subject& subject, EdgeId e, const Rational& squared_length) {
  const Rational slack = rational_from(subject.graph.slack());
  if (squared_length <= slack * slack) return false;
  const ExactComplex& complex = subject.graph.complex();
  const Point p = complex.vertices[complex.edges[e].tail],
              q = complex.vertices[complex.edges[e].head];
  const auto sources = complex.edge_sources[e];
  return std::any_of(sources.begin(), sources.end(), [&](SegmentId s) {
    const Segment segment = subject.input.segments[s];
    return (segment.a == p && segment.b == q) || (segment.a == q && segment.b == p);
  });
}

/// Whether exactly parallel edges leave both ends on the same side.
bool closes_strip(const LineGraph& graph, EdgeId e, const Rational& squared_length) {
  const auto& vertices = graph.complex().vertices;
  const Edge& edge = graph.complex().edges[e];
  if (std::max(graph.degree(edge.tail), graph.degree(edge.head)) > kMostAtEnd) return false;
  const auto direction = [&](VertexId v, EdgeId f) {
    const Point p = vertices[v], q = vertices[graph.other_end(f, v)];
    return Point{q.x - p.x, q.y - p.y};
  };
  const auto cross = [](const Point& u, const Point& w) { return Rational(u.x * w.y - u.y * w.x); };
  const auto is_long = [&](EdgeId f) {
    return graph.squared_length(f) >= kStrip * kStrip * squared_length;
  };
  const Point along = direction(edge.tail, e);
  for (const EdgeId f : graph.edges(edge.tail)) {
    if (f == e || !is_long(f)) continue;
    const Point u = direction(edge.tail, f);
    if (sgn(cross(along, u)) == 0) continue;
    for (const EdgeId g : graph.edges(edge.head)) {
      if (g == e || !is_long(g)) continue;
      const Point w = direction(edge.head, g);
      if (sgn(cross(u, w)) == 0 && sgn(Rational(u.x * w.x + u.y * w.y)) > 0) return true;
    }
  }
  return false;
}

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
    if (is_finely_drawn(graph, e, squared) || is_drawn(subject, e, squared)) continue;
    if (closes_strip(graph, e, squared)) {
      result.add_accident(e);  // as wide as the strip, which may be one
      continue;
    }
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

// The two complexes side by side, and what every step asks of them.

#include "crosscheck/sides.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plumbline/error.hpp"

namespace plumbline::matching {
namespace {

Lists<HalfedgeId> outgoing_halfedges(const ExactComplex& complex) {
  std::vector<std::vector<HalfedgeId>> at(complex.vertices.size());
  for (std::size_t e = 0; e < complex.edge_count(); ++e)
    for (const bool reversed : {false, true}) {
      const HalfedgeId h = halfedge(EdgeId(e), reversed);
      at[complex.origin(h)].push_back(h);
    }
  Lists<HalfedgeId> lists;
  for (const auto& halfedges : at) lists.push_back(halfedges);
  return lists;
}

std::vector<SegmentId> sorted_unique(std::vector<SegmentId> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

}  // namespace

Sides make_sides(const ExactComplex& exact_complex, const ExactComplex& float_complex,
                 double tolerance) {
  if (!std::isfinite(tolerance) || tolerance < 0)
    throw Error(ErrorCode::BadInput, "the tolerance must be a finite number, 0 or more", {},
                fmt::format("{}", tolerance));
  const Rational exact_tolerance = rational_from(tolerance);
  return {{&exact_complex, &float_complex},
          {outgoing_halfedges(exact_complex), outgoing_halfedges(float_complex)},
          tolerance,
          exact_tolerance * exact_tolerance};
}

EdgeId edge_between(const ExactComplex& complex, VertexId v, VertexId w) {
  const auto ends = std::minmax(v, w);
  const auto is_before = [](const Edge& e, const std::pair<VertexId, VertexId>& key) {
    return std::pair(e.tail, e.head) < key;
  };
  const auto it = std::lower_bound(complex.edges.begin(), complex.edges.end(),
                                   std::pair(ends.first, ends.second), is_before);
  if (it == complex.edges.end() || it->tail != ends.first || it->head != ends.second) return {};
  return EdgeId(static_cast<std::size_t>(it - complex.edges.begin()));
}

std::vector<std::size_t>& cells(Finding& finding, Side side) {
  return side == Exact ? finding.exact_cells : finding.float_cells;
}

std::vector<SegmentId> segments_of(const ExactComplex& complex, std::span<const EdgeId> edges) {
  std::vector<SegmentId> ids;
  for (const EdgeId e : edges) {
    const auto sources = complex.edge_sources[e];
    ids.insert(ids.end(), sources.begin(), sources.end());
  }
  return sorted_unique(std::move(ids));
}

std::vector<SegmentId> segments_at(const Sides& sides, Side side,
                                   std::span<const VertexId> vertices) {
  std::vector<EdgeId> edges;
  for (const VertexId v : vertices)
    for (const HalfedgeId h : sides.outgoing[side][v]) edges.push_back(edge_of(h));
  return segments_of(sides[side], edges);
}

std::vector<SegmentId> joined(std::vector<SegmentId> a, const std::vector<SegmentId>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return sorted_unique(std::move(a));
}

Point midpoint(const Point& a, const Point& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

Point midpoint(const ExactComplex& complex, EdgeId e) {
  const Edge& edge = complex.edges[e];
  return midpoint(complex.vertices[edge.tail], complex.vertices[edge.head]);
}

double length(const Rational& squared) { return std::sqrt(nearest_double(squared)); }

std::string rough(double value) { return fmt::format("{:.3g}", value); }

std::string counted(std::size_t n, const std::string& singular, const std::string& plural) {
  return n == 1 ? singular : fmt::format("{} {}", n, plural);
}

}  // namespace plumbline::matching

// The two complexes side by side, and what every step asks of them.

#include "compare/sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "plumbline/error.hpp"

namespace plumbline::compare_steps {
namespace {

Lists<HalfedgeId> outgoing_halfedges(const ExactComplex& complex) {
  std::vector<std::size_t> begin(complex.vertices.size() + 2);  // of the list after the next one
  for (const Edge& e : complex.edges) {
    ++begin[e.tail + std::size_t{2}];
    ++begin[e.head + std::size_t{2}];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<HalfedgeId> sorted(2 * complex.edge_count());
  for (std::size_t h = 0; h < sorted.size(); ++h) {
    sorted[begin[complex.origin(HalfedgeId(h)) + std::size_t{1}]++] = HalfedgeId(h);
  }
  Lists<HalfedgeId> lists;
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    lists.push_back(std::span(sorted).subspan(begin[v], begin[v + 1] - begin[v]));
  }
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
  if (!std::isfinite(tolerance) || tolerance < 0) {
    throw Error(ErrorCode::BadInput, "the tolerance must be a finite number, 0 or more", {},
                fmt::format("{}", tolerance));
  }
  const Rational exact_tolerance = rational_from(tolerance);
  return {{&exact_complex, &float_complex},
          {FilteredPoints(exact_complex.vertices), FilteredPoints(float_complex.vertices)},
          {outgoing_halfedges(exact_complex), outgoing_halfedges(float_complex)},
          tolerance,
          exact_tolerance * exact_tolerance};
}

EdgeId edge_between(const Sides& sides, Side side, VertexId v, VertexId w) {
  const auto [tail, head] = std::minmax(v, w);
  const auto leaving = sides.outgoing[side][tail];
  const auto is_before = [&](HalfedgeId h, VertexId key) {
    return is_reversed(h) || sides[side].edges[edge_of(h)].head < key;
  };
  const auto found = std::lower_bound(leaving.begin(), leaving.end(), head, is_before);
  if (found == leaving.end() || sides[side].edges[edge_of(*found)].head != head) return {};
  return edge_of(*found);
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
  for (const VertexId v : vertices) {
    for (const HalfedgeId h : sides.outgoing[side][v]) edges.push_back(edge_of(h));
  }
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

double length(const Rational& squared) { return nearest_sqrt(squared); }

std::string rough(double value) { return fmt::format("{:.3g}", value); }

std::string counted(std::size_t n, const std::string& singular, const std::string& plural) {
  return n == 1 ? singular : fmt::format("{} {}", n, plural);
}

}  // namespace plumbline::compare_steps

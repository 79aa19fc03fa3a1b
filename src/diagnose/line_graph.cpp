#include "diagnose/line_graph.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/point_d.hpp"

namespace plumbline::diagnose_steps {
namespace {

// Coordinates are off by half a unit in the last place of the largest, 2^-53 of it. A distance of a
// point from a line is computed from some ten such numbers, none more than four times the largest.
constexpr double kRelativeSlack = 0x1p-46;

}  // namespace

LineGraph::LineGraph(const ExactComplex& complex)
    : complex_(complex), begin_(complex.vertices.size() + 1) {
  for (const Edge& edge : complex.edges) {
    ++begin_[edge.tail + 1];
    ++begin_[edge.head + 1];
  }
  for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
  at_.resize(2 * complex.edge_count());
  std::vector<std::uint32_t> end(begin_.begin(), begin_.end() - 1);
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    at_[end[complex.edges[e].tail]++] = EdgeId(e);
    at_[end[complex.edges[e].head]++] = EdgeId(e);
  }
  points_.reserve(complex.vertices.size());
  for (const Point& p : complex.vertices) points_.push_back(nearest(p));
  slack_ = largest_coordinate(points_) * kRelativeSlack;
}

Chain LineGraph::chain(VertexId v, EdgeId e) const {
  Chain result{v, other_end(e, v), {e}};
  while (degree(result.last) == 2 && result.last != v) {
    e = next(e, result.last);
    result.edges.push_back(e);
    result.last = other_end(e, result.last);
  }
  return result;
}

double LineGraph::approx_length(EdgeId e) const {
  return distance(points_[complex_.edges[e].tail], points_[complex_.edges[e].head]);
}

Rational LineGraph::squared_length(EdgeId e) const {
  const Edge& edge = complex_.edges[e];
  return squared_distance(complex_.vertices[edge.tail], complex_.vertices[edge.head]);
}

Roots LineGraph::length(const Chain& chain) const {
  Roots length;
  for (const EdgeId e : chain.edges) length.add(squared_length(e));
  return length;
}

bool LineGraph::is_within(const Chain& chain, const Rational& distance) const {
  const double limit = nearest_double(distance) * (1 + kRelativeSlack) + slack_;
  double sum = 0;
  std::size_t edges = 0;
  for (const EdgeId e : chain.edges) {
    sum += approx_length(e);
    if (sum > (limit + static_cast<double>(++edges) * slack_) * (1 + kRelativeSlack)) return false;
  }
  return length(chain).compare(distance) <= 0;
}

bool LineGraph::is_within(EdgeId e, const Rational& distance) const {
  if (approx_length(e) > nearest_double(distance) * (1 + kRelativeSlack) + slack_) return false;
  return squared_length(e) <= distance * distance;
}

std::vector<SegmentId> LineGraph::segments(std::span<const EdgeId> edges) const {
  std::vector<SegmentId> result;
  for (const EdgeId e : edges) {
    const auto sources = complex_.edge_sources[e];
    result.insert(result.end(), sources.begin(), sources.end());
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace plumbline::diagnose_steps

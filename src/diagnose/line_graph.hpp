#pragma once

#include <span>
#include <vector>

#include "diagnose/roots.hpp"
#include "plumbline/complex.hpp"

namespace plumbline::diagnose_steps {

/// A path of edges, each starting where the one before it ends.
struct Chain {
  VertexId first, last;
  std::vector<EdgeId> edges;
};

/// The graph of a complex: what is at each vertex, and how long edges are.
class LineGraph {
 public:
  /// Keeps a reference to the complex.
  explicit LineGraph(const ExactComplex& complex);

  const ExactComplex& complex() const { return complex_; }
  std::span<const EdgeId> edges(VertexId v) const {
    return {at_.data() + begin_[v], begin_[v + 1] - begin_[v]};
  }
  std::size_t degree(VertexId v) const { return begin_[v + 1] - begin_[v]; }
  bool is_tip(VertexId v) const { return degree(v) == 1; }
  VertexId other_end(EdgeId e, VertexId v) const {
    const Edge& edge = complex_.edges[e];
    return edge.tail == v ? edge.head : edge.tail;
  }
  /// The edge at a vertex of degree 2 that is not e.
  EdgeId next(EdgeId e, VertexId v) const { return edges(v)[edges(v)[0] == e ? 1 : 0]; }
  /// From v along e to the first vertex that is not of degree 2, or back to v.
  Chain chain(VertexId v, EdgeId e) const;

  const std::vector<PointD>& rounded() const { return points_; }
  const PointD& rounded(VertexId v) const { return points_[v]; }
  /// Bounds what rounding does to a distance: of coordinates, and of computing with them.
  double slack() const { return slack_; }
  double approx_length(EdgeId e) const;
  Rational squared_length(EdgeId e) const;
  /// The length of a chain.
  Roots length(const Chain& chain) const;
  /// Whether the chain is no longer than this; cheap where it is obvious. **Exact**.
  bool is_within(const Chain& chain, const Rational& distance) const;
  bool is_within(EdgeId e, const Rational& distance) const;
  /// All input segments of the edges, ascending.
  std::vector<SegmentId> segments(std::span<const EdgeId> edges) const;

 private:
  const ExactComplex& complex_;
  std::vector<std::uint32_t> begin_;
  std::vector<EdgeId> at_;
  std::vector<PointD> points_;
  double slack_ = 0;
};

}  // namespace plumbline::diagnose_steps

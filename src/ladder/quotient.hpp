#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/union_find.hpp"
#include "plumbline/complex.hpp"

namespace plumbline {

/// The graph of a complex while vertices are merged and edges are led through vertices. An edge is
/// a chain of pieces; pieces whose ends are merged count for nothing, pieces with the same two ends
/// are one edge. The graph depends on the calls, not on their order.
class Quotient {
 public:
  /// Keeps a reference to the complex.
  explicit Quotient(const ExactComplex& complex);

  /// Cost: O(log n) expected, amortised.
  void merge(VertexId v, VertexId w);
  /// Leads the edge through the vertex, where the foot of the perpendicular from it on the edge
  /// lies; once. Requires: a foot inside. Cost: O(k) for k vertices that the edge is already led
  /// through.
  void lead_through(EdgeId e, VertexId v);
  /// Whether the edge is led through a vertex that is merged with neither of its ends.
  bool is_led_through_others(EdgeId e) const;

  std::size_t vertex_count() const { return vertices_; }
  std::size_t edge_count() const { return multiplicity_.size(); }
  /// By Euler's relation, with the unbounded face.
  std::size_t face_count() const { return 1 + components_ + edge_count() - vertices_; }
  /// A number for the vertex, the same for those that are merged.
  std::uint32_t cluster(VertexId v) const { return static_cast<std::uint32_t>(clusters_.find(v)); }

 private:
  struct Piece {
    VertexId from, to;
  };
  /// The tail of an edge or a vertex that it is led through, and the piece from there on.
  struct Stop {
    Rational along;
    VertexId vertex;
    std::uint32_t piece;
  };

  std::uint64_t key(const Piece& piece) const;
  void count(const Piece& piece);
  void discount(const Piece& piece);
  void connect(VertexId v, VertexId w);
  std::uint32_t add_piece(VertexId from, VertexId to);

  const ExactComplex& complex_;
  std::size_t vertices_, components_;
  mutable UnionFind clusters_;                                     ///< of merged vertices
  UnionFind connected_;                                            ///< vertices
  std::vector<Piece> pieces_;                                      ///< the first ones are the edges
  std::vector<std::vector<std::uint32_t>> pieces_at_;              ///< per cluster
  std::unordered_map<std::uint64_t, std::uint32_t> multiplicity_;  ///< pieces between two clusters
  std::unordered_map<std::size_t, std::vector<Stop>> stops_;       ///< per edge, from tail to head
};

}  // namespace plumbline

#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::mutations {

/// The members of a complex as lists that can be changed.
struct Parts {
  std::vector<Point> vertices;
  std::vector<Edge> edges;
  std::vector<std::vector<SegmentId>> edge_sources;
  std::vector<std::vector<HalfedgeId>> cycles;
  std::vector<CycleId> outer;
  std::vector<std::vector<CycleId>> holes;
  std::vector<std::vector<VertexId>> isolated;

  explicit Parts(const ExactComplex& complex);
  /// In canonical order.
  ExactComplex complex() const;

  void add_edge(VertexId tail, VertexId head);
  /// Leaves out the cycles for which `is_dropped` is set, and the faces whose outer boundaries they
  /// are.
  void drop_cycles(const std::vector<bool>& is_dropped);
};

/// Line work that can be changed and arranged anew: a valid complex of another drawing.
struct Drawing {
  std::vector<Segment> segments;
  std::vector<std::vector<SegmentId>> sources;  ///< per segment
  std::vector<Point> points;

  /// One segment per edge, one point per isolated vertex.
  explicit Drawing(const ExactComplex& complex);
  void add(const Point& a, const Point& b);
  /// Edges have the sources of the segments that cover them.
  ExactComplex arranged() const;
};

/// A right result and the dice. Everything about it is asked of here.
class Right {
 public:
  Right(const ExactComplex& complex, unsigned seed);

  const ExactComplex& operator*() const { return complex_; }
  const ExactComplex* operator->() const { return &complex_; }

  std::size_t below(std::size_t n) { return random_() % n; }
  /// One of those that satisfy the condition; an invalid id if there is none.
  template <class Id, class Condition>
  Id any(std::size_t count, Condition condition) {
    std::vector<Id> fitting;
    for (std::size_t i = 0; i < count; ++i) {
      if (condition(Id(i))) fitting.push_back(Id(i));
    }
    return fitting.empty() ? Id() : fitting[below(fitting.size())];
  }
  template <class Condition>
  VertexId vertex(Condition condition) {
    return any<VertexId>(complex_.vertices.size(), condition);
  }
  template <class Condition>
  EdgeId edge(Condition condition) {
    return any<EdgeId>(complex_.edge_count(), condition);
  }
  template <class Condition>
  FaceId bounded_face(Condition condition) {
    return any<FaceId>(complex_.face_count(),
                       [&](FaceId f) { return f != kUnbounded && condition(f); });
  }

  Point point(VertexId v) const { return complex_.vertices[v]; }
  Point tail(EdgeId e) const { return point(complex_.edges[e].tail); }
  Point head(EdgeId e) const { return point(complex_.edges[e].head); }
  Point middle(EdgeId e) const;
  const std::vector<VertexId>& neighbours(VertexId v) const { return neighbours_[v]; }
  /// A length well below the distances of vertices from each other and from edges.
  const Rational& small() const { return small_; }
  /// The small length in one of four directions.
  Point small_step();

 private:
  ExactComplex complex_;
  std::mt19937 random_;
  std::vector<std::vector<VertexId>> neighbours_;
  Rational small_;
};

/// Both ends of an edge.
std::vector<Point> ends(const Right& right, EdgeId e);

}  // namespace plumbline::mutations

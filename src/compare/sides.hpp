#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/filtered_points.hpp"
#include "plumbline/compare.hpp"

namespace plumbline::compare_steps {

/// The two complexes are treated alike: what is Missing on one side is Extra on the other, what is
/// Merged is Split.
enum Side : std::size_t { Exact, Float };
inline constexpr std::array kBothSides = {Exact, Float};
constexpr Side other(Side side) { return side == Exact ? Float : Exact; }
template <class T>
using Both = std::array<T, 2>;

/// What is compared: the exact complex and the float one, its doubles taken as exact.
struct Sides {
  Both<const ExactComplex*> complexes;
  Both<FilteredPoints> points;       ///< their vertices
  Both<Lists<HalfedgeId>> outgoing;  ///< per vertex, ascending: first those that run backwards
  double tolerance = 0;
  Rational squared_tolerance;

  const ExactComplex& operator[](Side side) const { return *complexes[side]; }
  Point point(Side side, VertexId v) const { return (*complexes[side]).vertices[v]; }
};

/// Throws: Error BadInput for a tolerance that is negative or not finite.
Sides make_sides(const ExactComplex& exact_complex, const ExactComplex& float_complex,
                 double tolerance);

/// The edge of a side between two vertices, the first of several; invalid if there is none.
EdgeId edge_between(const Sides& sides, Side side, VertexId v, VertexId w);

/// The name of a disagreement seen from a side: what is Missing or Merged for cells of the exact
/// side is Extra or Split for cells of the float side.
constexpr Disagreement lacking(Side side) {
  return side == Exact ? Disagreement::Missing : Disagreement::Extra;
}
constexpr Disagreement joining(Side side) {
  return side == Exact ? Disagreement::Merged : Disagreement::Split;
}
constexpr const char* name(Side side) { return side == Exact ? "exact" : "float"; }

/// The cells of a side in a finding.
std::vector<std::size_t>& cells(Finding& finding, Side side);

/// The segments that cover the edges, ascending, each once.
std::vector<SegmentId> segments_of(const ExactComplex& complex, std::span<const EdgeId> edges);
/// The segments that cover the edges at the vertices.
std::vector<SegmentId> segments_at(const Sides& sides, Side side,
                                   std::span<const VertexId> vertices);
/// Both lists as one, ascending, each once.
std::vector<SegmentId> joined(std::vector<SegmentId> a, const std::vector<SegmentId>& b);

Point midpoint(const Point& a, const Point& b);
Point midpoint(const ExactComplex& complex, EdgeId e);
/// Square root of an exact squared length. **Rounded**.
double length(const Rational& squared);
/// Numbers as a sentence shows them, three digits; "an edge", "3 edges" (with an adjective).
std::string rough(double value);
std::string counted(std::size_t n, const std::string& singular, const std::string& plural);

}  // namespace plumbline::compare_steps

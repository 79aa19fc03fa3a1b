#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "plumbline/detail/lists.hpp"
#include "plumbline/error.hpp"
#include "plumbline/geometry.hpp"
#include "plumbline/geometry/extent.hpp"
#include "plumbline/geometry/point_list.hpp"

namespace plumbline {

using VertexId = Index<struct VertexTag>;
using EdgeId = Index<struct EdgeTag>;
using HalfedgeId =
    Index<struct HalfedgeTag>;  ///< 2 e along edge e (tail to head), 2 e + 1 against it
using CycleId = Index<struct CycleTag>;
using FaceId = Index<struct FaceTag>;
using ComponentId = Index<struct ComponentTag>;

/// The unbounded face.
inline constexpr FaceId kUnbounded{0};

constexpr HalfedgeId halfedge(EdgeId e, bool reversed) {
  return HalfedgeId(2 * static_cast<std::size_t>(e) + (reversed ? 1 : 0));
}
constexpr HalfedgeId twin(HalfedgeId h) { return HalfedgeId(static_cast<std::size_t>(h) ^ 1U); }
constexpr EdgeId edge_of(HalfedgeId h) { return EdgeId(static_cast<std::size_t>(h) >> 1U); }
constexpr bool is_reversed(HalfedgeId h) { return (static_cast<std::size_t>(h) & 1U) != 0; }

struct Edge {
  VertexId tail;  ///< lexicographically first
  VertexId head;

  friend bool operator==(const Edge&, const Edge&) = default;
};

/// The incidences of a 2D cellular complex. A cycle is a closed walk of halfedges, each with the
/// cycle's face on its left: outer boundaries run counter-clockwise, holes clockwise. An edge with
/// the same face on both sides (an antenna) stands in that face's cycles once in each direction.
struct Incidences {
  // Given by whoever makes the complex, in any order.
  std::vector<Edge> edges;
  Lists<SegmentId> edge_sources;  ///< per edge, ascending: all input segments that cover it
  Lists<HalfedgeId> cycles;
  std::vector<CycleId> face_outer;  ///< per face its outer boundary; none for the unbounded face 0
  Lists<CycleId> face_holes;
  Lists<VertexId> face_isolated_vertices;

  // Derived by `canonical`.
  std::vector<FaceId> cycle_face;
  std::vector<FaceId> halfedge_face;          ///< the face on the left
  std::vector<ComponentId> vertex_component;  ///< connected components of the graph (V, E)
  std::vector<FaceId> component_parent;       ///< the face that contains the component
  std::vector<std::uint32_t> face_depth;      ///< 0 for the unbounded face, its parent's + 1 else

  std::size_t edge_count() const { return edges.size(); }
  std::size_t face_count() const { return face_outer.size(); }
  std::size_t component_count() const { return component_parent.size(); }
  VertexId origin(HalfedgeId h) const {
    const Edge& e = edges[edge_of(h)];
    return is_reversed(h) ? e.head : e.tail;
  }
  VertexId target(HalfedgeId h) const { return origin(twin(h)); }
  /// Whether the same face lies on both sides of the edge.
  bool is_antenna(EdgeId e) const {
    const FaceId f = halfedge_face[halfedge(e, false)];
    return f.valid() && f == halfedge_face[halfedge(e, true)];
  }
  /// The face that directly contains the component of bounded face f.
  FaceId parent(FaceId f) const;

  friend bool operator==(const Incidences&, const Incidences&) = default;
};

/// A 2D cellular complex: points and incidences.
template <class Points>
struct CellComplex : Incidences {
  Points vertices;

  friend bool operator==(const CellComplex&, const CellComplex&) = default;
};

using ExactComplex = CellComplex<PointList>;
using FloatComplex = CellComplex<std::vector<PointD>>;

/// The extent of its edges and isolated vertices, in this order.
Extent extent(const ExactComplex& complex);
Extent extent(const FloatComplex& complex);

/// The same complex in canonical order, with the derived members filled in: vertices by (x, y);
/// edges by (tail, head), tail first; cycles start at their least halfedge and are sorted by it;
/// face 0 is unbounded, the others are sorted by their outer cycle; holes, isolated vertices and
/// sources ascending; components by their least vertex. Two complexes of the same subdivision
/// become equal, member by member. Requires: indices in range, a face 0 without outer boundary.
/// Degenerate: a complex that breaks the invariants is ordered as far as it can be; `validate`
/// tells. Where a component is bounded by no hole, its parent is the unbounded face. Cost: O(n log
/// n). Throws: Error Internal where an index is out of range.
ExactComplex canonical(ExactComplex complex);
FloatComplex canonical(FloatComplex complex);

/// The complex with every coordinate rounded to the nearest double (**Rounded**: edges may then
/// cross and vertices coincide), and with every double taken as the rational that it is
/// (**Exact**).
FloatComplex nearest(const ExactComplex& complex);
ExactComplex exact(const FloatComplex& complex);

/// 32 hexadecimal digits that depend on the canonical exact complex (coordinates and incidences;
/// not on sources, engine, input order, duplicates or platform). XXH3-128 of its canonical bytes.
std::string signature(const ExactComplex& complex);

/// Numbers of cells, for the report: faces with the unbounded one, holes of bounded faces only (a
/// hole of the unbounded face is the outline of a component), the greatest nesting depth.
struct Counts {
  std::size_t vertices = 0, edges = 0, faces = 0, holes = 0, isolated_vertices = 0;
  std::size_t components = 0, antennas = 0, depth = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};
Counts counts(const Incidences& complex, std::size_t vertex_count);

/// Exact signed areas, per cycle, by the shoelace formula (positive: counter-clockwise).
std::vector<Rational> cycle_areas(const ExactComplex& complex);
/// Exact areas, per face, holes subtracted; 0 for the unbounded face.
std::vector<Rational> face_areas(const ExactComplex& complex);
Rational face_area(const ExactComplex& complex, FaceId f);

/// The point strictly inside bounded face f that docs/certificate.md names: half-way between the
/// two successive heights of its vertices that are farthest apart, the middle of the widest piece.
/// **Exact**. Requires: a valid complex, f != kUnbounded. Cost: O(k log k) for k edges of the face.
Point interior_point(const ExactComplex& complex, FaceId f);

/// The face that contains p; for a point on a vertex or an edge, a face that has it on its
/// boundary.
/// **Exact**. Cost: O(E).
FaceId locate(const ExactComplex& complex, const Point& p);
/// The faces that contain the points, as `locate` tells one by one. **Exact**. Degenerate: the
/// complex need not be valid; then the face is that on the near side of the first edge to the
/// right. Cost: O(E log E), and for each point the edges that a horizontal line through it meets.
std::vector<FaceId> locate_all(const ExactComplex& complex, const std::vector<Point>& points);

/// The least distance between two distinct vertices, and between a vertex and an edge that it does
/// not bound. Squared, **exact**. Requires: a valid complex with at least one edge.
struct FeatureSize {
  Rational squared_vertex_vertex;
  VertexId v, w;                 ///< of several pairs that are as near the first, here and below
  Rational squared_vertex_edge;  ///< 0 and invalid ids where there is no such pair
  VertexId vertex;
  EdgeId edge;
};
FeatureSize feature_size(const ExactComplex& complex);

/// The invariants of a cellular complex that `validate` checks.
enum class Invariant {
  Index,            ///< every index in range, edges with two different ends
  HalfedgeInCycle,  ///< each halfedge in exactly one cycle
  CycleClosed,      ///< each halfedge of a cycle starts where the one before it ends
  Derived,          ///< faces of cycles and halfedges, components and depths follow from the rest
  BoundaryOfBoundary,  ///< d1 d2 = 0
  Orientation,         ///< outer boundaries counter-clockwise, holes clockwise (or of area 0)
  Crossing,            ///< no two edges meet except at common vertices
  VertexOnEdge,        ///< no vertex in the interior of an edge
  DuplicateVertex,
  DuplicateEdge,
  CyclicOrder,  ///< around a vertex, a cycle turns from a halfedge to the next one clockwise
  Nesting,      ///< each hole and isolated vertex lies inside its face, and in no deeper one
  Euler,        ///< V - E + F = 1 + C
  Area,         ///< faces inside an outer boundary add up to the area that it encloses
  Coverage,     ///< the union of the edges is the union of the input segments
};
std::string to_text(Invariant invariant);

/// One broken invariant.
struct Violation {
  Invariant invariant;
  std::string message;
  Point where;
  std::vector<VertexId> vertices;
  std::vector<EdgeId> edges;
  std::vector<FaceId> faces;
};

/// All violations of the invariants, in the order of `Invariant`; empty for a valid complex.
/// Requires: `canonical` was called. **Exact**. At most kMaxViolations of each kind are listed.
/// Cost: O(n log n) plus the pairs of edges whose boxes overlap in x.
std::vector<Violation> validate(const ExactComplex& complex);
/// The violations of Coverage: each source of an edge covers it; the edges of each segment cover
/// the segment without gap; each input point is a vertex.
std::vector<Violation> validate_coverage(const ExactComplex& complex, const SegmentSet& input);
inline constexpr std::size_t kMaxViolations = 1000;

}  // namespace plumbline

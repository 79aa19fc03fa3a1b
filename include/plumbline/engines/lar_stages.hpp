#pragma once

#include <array>
#include <span>
#include <vector>

#include "plumbline/engines/lar.hpp"

/// The stages of the repaired pipeline in their order, each a pure function on doubles; `arrange`
/// calls them one after the other. "Section" is that of Paoluzzi, "Accelerated intersection of
/// geometric objects", November 2015. Every result is **Rounded**, and a function of its arguments
/// alone: no hash order, no seed. **Requires**, everywhere: coordinates below 2^101 and a
/// radius of at least kLeastRelativeRadius times the largest, as `to_doubles` gives them; lists
/// that fit each other, as the stages before leave them, in particular indices of what is there.
namespace plumbline::lar {

/// The drawing in doubles, scaled by a power of two so that squares and products neither overflow
/// nor vanish.
struct Drawing {
  Graph graph;
  double radius = 0;  ///< as scaled as the graph
  bool radius_from_segment = false;
  int exponent = 0;  ///< the scale is 2^-exponent
};

/// Every coordinate rounded to the nearest double; equal and reversed segments once, with all their
/// ids. Vertices ascending, edges by (tail, head), isolated points last. Degenerate: segments that
/// round to a point are dropped. Throws: as `arrange`. Section 4 (normalisation of the input).
Drawing to_doubles(const SegmentSet& input, const Options& options);

/// The containment box of every edge, grown by `margin` on all sides. Order: as the edges.
/// Cost: O(n). Section 2.1.
std::vector<Box> containment_boxes(const Graph& graph, double margin);

/// Buckets of boxes, such that two boxes that meet share a bucket: iterated splitting at a
/// threshold, first in y, then in x; a box on the threshold goes to both sides. The threshold is
/// the 1D centroid, or the median where the centroid separates little; a bucket is final when it
/// has fewer than four members or when neither pays (repaired: the published rule can double the
/// bucket at every step). Buckets ascending by members, each once. Cost: O(n log n) where
/// boxes are small. Section 2.1.
Lists<EdgeId> box_buckets(std::span<const Box> boxes);

/// The buckets with full ones split anew after a turn by their edges' common direction, where that
/// spares half of the pairs; two edges within twice the margin of each other still share a bucket.
/// Repaired: the publication has upright boxes only. Order and cost as above. Section 2.1.
Lists<EdgeId> refine_buckets(const Graph& graph, const Lists<EdgeId>& buckets, double margin);

/// At most two cuts.
class CutPair {
 public:
  void push_back(const Cut& cut) { cuts_[size_++] = cut; }
  const Cut* begin() const { return cuts_.data(); }
  const Cut* end() const { return cuts_.data() + size_; }

 private:
  std::array<Cut, 2> cuts_;
  std::size_t size_ = 0;
};

/// Where two segments cut each other.
struct Meeting {
  CutPair on_first;
  CutPair on_second;
};

/// An end of one segment within the radius of the other segment cuts it there (so T junctions and
/// collinear overlaps, whose ends cut each other), unless it is within the radius of an end, where
/// pruning will merge the two, or the cut would not shorten the segment. If no end is that near,
/// the segments cut each other where they cross properly, by division and not by a reciprocal, both
/// in the same point. Degenerate: equal segments do not cut each other. Section 2.2.
Meeting meet(const SegmentD& first, const SegmentD& second, double radius);

/// So many cuts take some gigabytes.
inline constexpr std::size_t kMaxCuts = std::size_t{1} << 26U;
/// Per edge its cuts by all edges that share a bucket with it, by parameter. Of cuts that differ by
/// rounding only (less than a quarter of the least radius) one is kept. All pieces are shorter than
/// the edge. Cost: O(pairs that share a bucket), in parallel. Throws: Error Limit where edges cut
/// each other in more than so many places, as k^2 places of a jittered pencil of k lines; places
/// that rounding alone tells apart count once or little more. Section 2.2.
Lists<Cut> cut_edges(const Graph& graph, std::span<const Box> boxes, const Lists<EdgeId>& buckets,
                     double radius, std::size_t max_cuts = kMaxCuts);

/// The graph of the pieces, double edges included; points with equal coordinates are one vertex;
/// vertices ascending. Order: edges along the edge that they are of. Cost: O(n log n). Section 2.3.
Graph split_edges(const Graph& graph, const Lists<Cut>& cuts);

/// The quotient of the points by the transitive closure of "no further apart than the radius"; each
/// cluster becomes its centroid. Clusters ascending by centroid, members ascending. Cost: O(n log n
/// + near pairs). Section 2.9.
Pruning prune_vertices(std::span<const PointD> vertices, double radius);

/// The graph over the merged vertices: edges that became a point are dropped, double edges are one
/// with the sources of all, vertices without edge are dropped. Edges ascending, isolated points
/// last. Cost: O(n log n). Section 2.9.
Graph simplify(const Graph& graph, const Pruning& pruning);

/// One round: the stages from containment boxes to `simplify`.
Round resolve(const Graph& graph, double radius);

/// The maximal 2-connected subgraphs with two or more edges, and the edges in none. Both ascending.
struct Biconnected {
  Lists<EdgeId> components;
  std::vector<EdgeId> bridges;
};
/// Hopcroft-Tarjan, without recursion. Isolated points are ignored. Cost: O(n). Section 2.4.
Biconnected biconnected_components(const Graph& graph);

/// Per vertex the halfedges that leave it, counter-clockwise by slope from -pi (excluded) to pi;
/// ties by target; none at an isolated point. Cost: O(n log n). Section 2.5.
Lists<HalfedgeId> edge_slope_ordering(const Graph& graph);

/// The cycles of the face walk: after a halfedge comes the one clockwise next to its twin, so that
/// the face is on the left. Every halfedge is in one cycle; a cycle starts with its least halfedge,
/// and cycles ascend by it. Cost: O(n). Section 2.5.
Lists<HalfedgeId> face_cycles(const Graph& graph, const Lists<HalfedgeId>& edge_order);

/// Signed area per cycle, positive when counter-clockwise; 0 for a tree. Cost: O(n).
/// Section 2.5 (areas of larFromLines).
std::vector<double> cycle_areas(const Graph& graph, const Lists<HalfedgeId>& cycles);

/// The exterior cycle of a connected component.
struct Exterior {
  CycleId cycle;
  VertexId least_vertex;  ///< of the component
};
/// Per connected component the cycle that sees the component's least vertex from the left.
/// Ascending by that vertex. Cost: O(n). Repaired: the publication takes the cycle of largest area
/// over the whole drawing. Section 2.5.
std::vector<Exterior> exterior_cycles(const Graph& graph, const Lists<HalfedgeId>& edge_order,
                                      const Lists<HalfedgeId>& cycles);

enum class Position { Out, In, On };
/// Where each point lies relative to the region that a closed polygon bounds by parity, by the tile
/// codes of the polygon's vertices around the point. The polygon may touch itself or run along an
/// edge twice; none has nothing inside. Cost: O(k log m + pairs of an edge and a point at its
/// height). Section 2.10.
std::vector<Position> classify_points(std::span<const PointD> polygon,
                                      std::span<const PointD> points);

/// Per vertex the innermost of the `outer` cycles with the vertex inside; none where none has.
/// Every cycle has its area in `areas`. Repaired: the publication compares the first vertex of each
/// cycle with every other. Cost: as `classify_points`, per cycle with the vertices in its box.
/// Section 2.6 (latticeArray).
std::vector<CycleId> innermost_cycles(const Graph& graph, const Lists<HalfedgeId>& cycles,
                                      std::span<const double> areas, std::span<const CycleId> outer,
                                      std::span<const VertexId> vertices);

/// The complex: a face per outer cycle, its holes the exterior cycles whose innermost cycle it is,
/// its isolated vertices likewise; not yet in canonical order. Cost: as `innermost_cycles`. Section
/// 2.6 (cellsFromCycles).
FloatComplex cells(const Graph& graph, const Lists<HalfedgeId>& cycles,
                   std::span<const Exterior> exteriors, std::span<const double> areas);

/// The complex of a graph that no more rounds change: the stages from `edge_slope_ordering` to
/// `cells`. Not yet in canonical order.
FloatComplex faces(const Graph& graph);

}  // namespace plumbline::lar

#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/inters_vcode.hpp"
#include "plumbline/error.hpp"

/// The stages of the published pipeline in their order, each a pure function on doubles; `run`
/// calls them one after the other. The original's functions are named in brackets; "Section" is
/// that of Paoluzzi, "Accelerated intersection of geometric objects", November 2015; ids as I9 are
/// those of the divergence catalogue, docs/divergences.md. Every result is **Rounded**, and lists
/// have the order of the original's. "Fails" means: throws StageFailure. **Requires**, everywhere:
/// finite coordinates; lists that fit each other, as the stages before leave them, in particular
/// indices of what is there.
namespace plumbline::inters {

/// Thrown by a stage where the original crashed or ran for ever; `run` records it instead. Its code
/// is BadInput.
class StageFailure : public Error {
 public:
  explicit StageFailure(Failure failure);
  /// `stage` is filled in by `run` alone.
  const Failure& failure() const { return failure_; }

 private:
  Failure failure_;
};

/// Lines and rectangles of SVG text, mapped to the unit square (svg2lines): elements that stand on
/// a text line of their own and have their attributes in the one order that the patterns know (S2
/// to S5, S7); integers divide as integers (S1). Rectangles as four sides or as one diagonal.
/// Order: lines, then rectangles, as in the text. Cost: O(n). Fails where no element matches
/// (SyntaxError) or there is none (TypeError), and as below. Section 4.
std::vector<SegmentD> svg_to_lines(std::string_view svg, bool rectangles_as_sides,
                                   const Vcode& vcode);

/// The window-to-viewport map of svg2lines: the longer side becomes 1, the shorter one is not
/// centred, y is turned upwards; quantised. Order: as given. Cost: O(n). Fails for a drawing
/// without width or height (S6, ZeroDivisionError), and for none (TypeError). Section 4.
std::vector<SegmentD> to_unit_square(std::span<const SegmentD> segments, const Vcode& vcode);

/// The quantised containment box of every segment (containment2DBoxes). Order: as given. Cost:
/// O(n). Section 2.1.
std::vector<Box> containment_boxes(std::span<const SegmentD> lines, const Vcode& vcode);

/// Buckets of long segments can double at every step: this many members take a gigabyte.
inline constexpr std::size_t kMaxMembers = std::size_t{1} << 28U;
/// Per box the others that share a final bucket with it, ascending (boxBuckets, geomPartitionate):
/// every bucket is split at the 1D centroid in y, each half in x; a half's parts are final when
/// both have fewer than four members or one drops fewer than seven. Fails where the centroid of
/// equal values is above them by rounding, and for no boxes (I9). Throws: Error Limit where more
/// than so many members pass through buckets, or others are listed. Cost: long segments are
/// repeated up to that limit. Section 2.1.
Lists<SegmentId> box_buckets(std::span<const Box> boxes, std::size_t max_members = kMaxMembers);

/// What `line_intersection` found.
struct Intersections {
  std::vector<PointD> points;  ///< quantised, distinct, ascending
  std::vector<Fragment> fragments;
};
/// Brute force within the buckets (segmentIntersect, lineBucketIntersect, lineIntersection): each
/// pair twice, with unquantised coordinates; parameters compared exactly with 0 and 1 after a
/// product with the reciprocal of the determinant (I3 to I5), parallel segments never cut (I1, I2),
/// parameters quantised (I6, Q3). Fragments in the order of a dictionary. Requires: where k is in
/// the bucket of h, h is in that of k. Cost: O(members of buckets), in parallel. Section 2.2.
Intersections line_intersection(std::span<const SegmentD> lines, std::span<const Box> boxes,
                                const Lists<SegmentId>& buckets, const Vcode& vcode);

/// The 1-complex of split segments.
struct Split {
  Model model;  ///< each pair of vertices once
  std::size_t edge_count_with_duplicates = 0;
};
/// The 1-complex of the fragments' pieces (first part of lines2lar): vertices are equal where their
/// quantised texts are, numbered by first use. A segment without length is an edge of one vertex.
/// Cost: O(pieces). Section 2.3.
Split split(std::span<const Fragment> fragments, const Vcode& vcode);

/// So many pairs take some gigabytes.
inline constexpr std::size_t kMaxPairs = std::size_t{1} << 26U;
/// The quotient by the transitive closure of nearness (pruneVertices; Q1, Q2). Throws: Error Limit
/// for more than so many pairs within the radius; BadInput for a radius that is not positive and
/// finite. Cost: O(n log n + pairs). Section 2.9.
Pruned prune_vertices(std::span<const PointD> vertices, double radius,
                      std::size_t max_pairs = kMaxPairs);

/// Edges over the merged vertices, without those that became a point, each once (larSimplify), in
/// the order of a set; but where the first raw edge is a point, points stay (I10). Cost: O(n).
/// Section 2.9.
Model simplify(const Model& raw, const Pruned& pruned);

/// The biconnected components of two or more edges, and the edges in none.
struct Biconnected {
  std::vector<std::vector<VertexPair>> components;  ///< each in the order of a set
  std::vector<VertexPair> bridges;
};
/// Hopcroft-Tarjan from vertex 0 up, neighbours ascending (biconnectedComponent). Bridges, which
/// the original drops, ascending. Edges of one vertex are in neither. Fails for no edges (I7).
/// Without recursion (F7). Cost: O(n log n). Section 2.4.
Biconnected biconnected_components(const Model& model);

/// Edges over vertices renumbered by first use, their coordinates quantised (larRemoveVertices);
/// vertices whose quantised texts are equal become one. Edges as given. Cost: O(n). Section 2.9.
Model remove_vertices(std::span<const PointD> vertices, std::span<const VertexPair> edges,
                      const Vcode& vcode);

/// Per vertex the edges around it, counter-clockwise by slope (edgeSlopeOrdering), ties by
/// edge. Cost: O(n log n). Section 2.5.
Lists<EdgeId> edge_slope_ordering(const Model& model);

/// An entry of the sparse vertex-edge matrix: around the vertex, the edge after `edge`.
struct NextEdge {
  VertexId vertex;
  EdgeId edge;
  EdgeId next;
};
/// The matrix of next edges (ordered_csrVE), rows ascending; at an end of a single edge that
/// edge is its own next. Cost: O(n). Section 2.5.
std::vector<NextEdge> ordered_vertex_edges(const Lists<EdgeId>& slope_order);

/// The faces of the model (facesFromComps): a walk goes to the next edge counter-clockwise and ends
/// when its first vertex comes back (F4). Edges in the order of a set. Aborts (Q6) or fails with
/// NoTermination (Q4, F4) where merging has made the model non-planar; fails for no edge with two
/// vertices. Cost: O(n log n) for planar models, at worst O(n^2) steps. Section 2.5.
Faces faces_from_components(const Model& model);

/// Absolute area of each face in single precision (surfIntegration; F6), by triangles from its
/// first vertex; 0 for fewer than three. Cost: O(vertices of faces). Section 2.8.
std::vector<double> surface_integration(const Model& model);

/// The face traversal of the component with most edges, the first of equals (F1, F2).
/// Requires: a component. Fails as `faces_from_components`. Section 2.8.
Faces largest_component_faces(const Model& lar, std::span<const std::vector<VertexPair>> components,
                              const Vcode& vcode);
/// Its faces by area, then by their vertices, without the last (larFromLines): the largest is taken
/// for the exterior. Section 2.8.
Model without_exterior(const Faces& largest);
/// All components together; interior are the faces whose area is not the largest (F5). Fails where
/// there is no component (F8), and as `faces_from_components`. Section 4, tests 08 and 09.
AllComponents all_component_faces(const Model& lar,
                                  std::span<const std::vector<VertexPair>> components,
                                  const Vcode& vcode);

/// The closed walks of all edges (boundaryCycles), which must form simple cycles: else it fails
/// (P6). Order: by least edge. Cost: O(n log n). Section 2.12.
std::vector<SignedCycle> boundary_cycles(std::span<const VertexPair> edges);

/// The cycle or cycles of edges as closed polylines of quantised points (boundaryPolylines; P8).
/// Fails where they are not simple (P6). Order: by a set of first vertices. Section 2.12.
std::vector<Polyline> boundary_polylines(std::span<const PointD> vertices,
                                         std::span<const VertexPair> edges, const Vcode& vcode);

enum class Classification { Out, In, On };
/// Where the point lies relative to the region within the polylines, by tile codes
/// (pointInPolygonClassification, setTile). Half crossings never count (P1, P2). Degenerate:
/// outside of nothing. Cost: O(points of the polylines). Section 2.10.
Classification classify(std::span<const Polyline> polygon, const PointD& point);

/// Which cycle contains which (latticeArray; P3 to P5): each polygon with the first vertex of every
/// cycle. Requires: no empty cycle. Fails where one is not simple (P6). Cost: O(cycles x edges).
/// Section 2.6.
LatticeArray lattice_array(std::span<const PointD> vertices,
                           std::span<const std::vector<VertexPair>> cycles, const Vcode& vcode);

/// Cells of solid and void by turns (cellsFromCycles; P7): an outer cycle and the cycles one level
/// inside it; by level. Requires: a square array. Section 2.6.
CycleCells cells_from_cycles(const LatticeArray& lattice);

/// The model whose faces are the cells, each as the vertices of its cycles one after the other, in
/// the order of sets. Section 2.11.
Model two_complex(const Model& lar, std::span<const std::vector<VertexPair>> cycles,
                  const CycleCells& cells);

/// Per cell its bridge edges (scan, connectTheDots): where vertices in lexicographic order change
/// cycle, the nearest vertices of both cycles, unless both were met before; the last bridge is
/// dropped. They may cross edges. Section 2.7.
std::vector<std::vector<VertexPair>> bridge_edges(
    std::span<const PointD> vertices, std::span<const std::vector<VertexPair>> components,
    const CycleCells& cells);

}  // namespace plumbline::inters

#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "lar/published/vcode.hpp"
#include "plumbline/published.hpp"

/// The stages of the published pipeline in their order, each a pure function on doubles, named
/// after the original's. "Section" is that of Paoluzzi, "Accelerated intersection of geometric
/// objects", November 2015; the ids in brackets are those of the divergence catalogue,
/// docs/divergences.md.
namespace plumbline::lar::published {

/// Thrown by a stage where the original crashed or ran for ever; caught by `run`.
struct StageFailure {
  Failure failure;
};
/// Throws StageFailure. The stage is filled in by `run`.
[[noreturn]] void fail(const char* error, const char* message, const char* function);

/// Throws: Error BadInput for a radius that is not positive and finite.
void check_radius(double radius);

/// Lines and rectangles of SVG text, mapped to the unit square (svg2lines): elements that stand on
/// a text line of their own and have their attributes in the one order that the patterns know (S2
/// to S5, S7); integers divide as integers (S1). Rectangles as four sides or as one diagonal. Fails
/// where no element matches (SyntaxError) or there is none (TypeError), and as below. Section 4.
std::vector<SegmentD> svg_to_lines(std::string_view svg, bool rectangles_as_sides,
                                   const Vcode& vcode);

/// The window-to-viewport map of svg2lines: the longer side becomes 1, the shorter one is not
/// centred, y is turned upwards; quantised. Fails for a drawing without width or height (S6,
/// ZeroDivisionError).
std::vector<SegmentD> to_unit_square(std::span<const SegmentD> segments, const Vcode& vcode);

/// The quantised containment box of every segment (containment2DBoxes). Section 2.1.
std::vector<Box> containment_boxes(std::span<const SegmentD> lines, const Vcode& vcode);

/// Buckets of long segments can double at every step: this many members take a gigabyte.
inline constexpr std::size_t kMaxMembers = std::size_t{1} << 28U;
/// Per box the others that share a final bucket with it, ascending (boxBuckets, geomPartitionate):
/// every bucket is split at the 1D centroid in y, each half in x; a half's parts are final when
/// both have fewer than four members or one drops fewer than seven. Fails where the centroid of
/// equal values is above them by rounding, and for no boxes (I9). Throws: Error Limit where more
/// than so many members pass through buckets, or others are listed. Section 2.1.
Lists<SegmentId> box_buckets(std::span<const Box> boxes, std::size_t max_members = kMaxMembers);

/// Result of `line_intersection`.
struct Intersections {
  std::vector<PointD> points;
  std::vector<Fragment> fragments;
};
/// Brute force within the buckets (segmentIntersect, lineBucketIntersect, lineIntersection): each
/// pair twice, with unquantised coordinates; parameters compared exactly with 0 and 1 after a
/// product with the reciprocal of the determinant (I3 to I5), parallel segments never cut (I1, I2),
/// parameters quantised (I6, Q3). Fragments in the order of a dictionary. Requires: where k is in
/// the bucket of h, h is in that of k. Section 2.2.
Intersections line_intersection(std::span<const SegmentD> lines, std::span<const Box> boxes,
                                const Lists<SegmentId>& buckets, const Vcode& vcode);

/// Result of `split`.
struct Split {
  Model model;
  std::size_t edge_count_with_duplicates = 0;
};
/// The 1-complex of the fragments' pieces (first part of lines2lar): vertices are equal where their
/// quantised texts are, numbered by first use. Section 2.3.
Split split(std::span<const Fragment> fragments, const Vcode& vcode);

/// So many pairs take some gigabytes.
inline constexpr std::size_t kMaxPairs = std::size_t{1} << 26U;
/// The quotient by the transitive closure of nearness (pruneVertices; Q1, Q2). Throws: Error Limit
/// for more than so many pairs within the radius. Section 2.9.
Pruned prune_vertices(std::span<const PointD> vertices, double radius,
                      std::size_t max_pairs = kMaxPairs);

/// Edges over the merged vertices, without those that became a point, each once (larSimplify), in
/// the order of a set; but where the first raw edge is a point, points stay (I10). Section 2.9.
Model simplify(const Model& raw, const Pruned& pruned);

struct Biconnected {
  std::vector<std::vector<VertexPair>> components;
  std::vector<VertexPair> bridges;
};
/// Hopcroft-Tarjan from vertex 0 up, neighbours ascending (biconnectedComponent). Bridges, which
/// the original drops, ascending. Fails for no edges (I7). Without recursion (F7). Section 2.4.
Biconnected biconnected_components(const Model& model);

/// Edges over vertices renumbered by first use, their coordinates quantised (larRemoveVertices).
Model remove_vertices(std::span<const PointD> vertices, std::span<const VertexPair> edges,
                      const Vcode& vcode);

/// Per vertex the edges around it, counter-clockwise by slope (edgeSlopeOrdering). Section 2.5.
Lists<EdgeId> edge_slope_ordering(const Model& model);

/// An entry of the sparse vertex-edge matrix: around the vertex, the edge after `edge`.
struct NextEdge {
  VertexId vertex;
  EdgeId edge;
  EdgeId next;
};
/// The matrix of next edges (ordered_csrVE), rows ascending. Section 2.5.
std::vector<NextEdge> ordered_vertex_edges(const Lists<EdgeId>& slope_order);

/// The distinct edges without zero edges, in the order of a set (first step of facesFromComps).
std::vector<VertexPair> set_of_edges(std::span<const VertexPair> edges);

/// The faces of the model (facesFromComps): a walk goes to the next edge counter-clockwise and ends
/// when its first vertex comes back (F4). Edges in the order of a set. Aborts (Q6) or fails with
/// NoTermination (Q4, F4) where merging has made the model non-planar. Section 2.5.
Faces faces_from_components(const Model& model);

/// Absolute areas in single precision (surfIntegration; F6). Section 2.8.
std::vector<double> surface_integration(const Model& model);

/// The face traversal of the component with most edges, the first of equals (F1, F2).
Faces largest_component_faces(const Model& lar, std::span<const std::vector<VertexPair>> components,
                              const Vcode& vcode);
/// Its faces by area without the last (larFromLines). Section 2.8.
Model without_exterior(const Faces& largest);
/// All components together; interior are the faces whose area is not the largest (F5). Fails where
/// there is no component (F8). Section 4, tests 08 and 09.
AllComponents all_component_faces(const Model& lar,
                                  std::span<const std::vector<VertexPair>> components,
                                  const Vcode& vcode);

/// The closed walks of all edges (boundaryCycles), which must form simple cycles: else it fails
/// (P6). Section 2.12.
std::vector<SignedCycle> boundary_cycles(std::span<const VertexPair> edges);

/// The cycle or cycles of edges as closed polylines of quantised points (boundaryPolylines; P8).
/// Section 2.12.
std::vector<Polyline> boundary_polylines(std::span<const PointD> vertices,
                                         std::span<const VertexPair> edges, const Vcode& vcode);

enum class Classification { Out, In, On };
/// Where the point lies relative to the region within the polylines, by tile codes
/// (pointInPolygonClassification, setTile). Half crossings never count (P1, P2). Section 2.10.
Classification classify(std::span<const Polyline> polygon, const PointD& point);

/// Section 2.6 (latticeArray; P4, P5). Fails where a cycle is not simple (P6).
LatticeArray lattice_array(std::span<const PointD> vertices,
                           std::span<const std::vector<VertexPair>> cycles, const Vcode& vcode);

/// Cells of solid and void by turns (cellsFromCycles; P7). Section 2.6.
CycleCells cells_from_cycles(const LatticeArray& lattice);

/// The vertices of a cycle, in the order of a set of numbers.
std::vector<VertexId> cycle_vertices(std::span<const VertexPair> edges);

/// The model whose faces are the cells, each as the vertices of its cycles one after the other.
/// Section 2.11.
Model two_complex(const Model& lar, std::span<const std::vector<VertexPair>> cycles,
                  const CycleCells& cells);

/// Per cell its bridge edges (scan, connectTheDots): where vertices in lexicographic order change
/// cycle, the nearest vertices of both cycles, unless both were met before; the last bridge is
/// dropped. They may cross edges. Section 2.7.
std::vector<std::vector<VertexPair>> bridge_edges(
    std::span<const PointD> vertices, std::span<const std::vector<VertexPair>> components,
    const CycleCells& cells);

}  // namespace plumbline::lar::published

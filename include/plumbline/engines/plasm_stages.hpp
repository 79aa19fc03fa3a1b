#pragma once

#include <span>
#include <vector>

#include "plumbline/engines/plasm.hpp"

/// The stages of Plasm.jl's 2D arrangement in their order, each a function on doubles. **Rounded**.
namespace plumbline::plasm {

/// Every coordinate rounded to the nearest double; vertices numbered as they first come, equal ones
/// once; an edge for each segment with length. Throws: as `run`.
Graph to_doubles(const SegmentSet& input);

/// Where one edge is cut by another one.
struct Cut {
  double parameter = 0;  ///< from the lesser vertex (0) to the greater one (1)
  PointD point;
};
struct Meeting {
  /// Parallel: the cosine between the edges is nearer to 1 than the radius. Collinear: so is that
  /// to the start of the other edge, or that start is within the radius.
  enum class Kind { Crossing, Parallel, Collinear };
  Kind kind = Kind::Crossing;
  std::vector<Cut> cuts;  ///< of the first edge alone
  double on_second = 0;   ///< of Crossing: the other edge's parameter there
  double on_first = 0;    ///< the same of the first edge
};
/// Parallel edges do not cut each other; collinear ones at the other's ends as they are, though
/// beside the edge; others where their lines cross, if both parameters are within the radius of 0
/// to 1, whatever the lengths.
Meeting meet(const SegmentD& first, const SegmentD& second, double radius);

/// Per edge the others whose boxes touch its own, not grown: by the ends of their boxes in x.
std::vector<std::vector<EdgeId>> partners(const Graph& graph);

/// Most cuts.
inline constexpr std::size_t kMaxCuts = std::size_t{1} << 26U;
/// The pieces of the edges between successive parameters; of cuts with equal parameters the last
/// one is taken, others stay apart however near. Cost: O(pairs of boxes that touch). Throws: Error
/// Limit for more cuts.
Graph fragment(const Graph& graph, double radius, std::size_t max_cuts = kMaxCuts);

/// Vertices in their order: one that none before it took takes all within the radius, those that an
/// earlier one took, too. Nothing moves to a mean. Cost: O(n log n + pairs of vertices that are
/// within the radius in x).
Merging merge(const Graph& fragments, double radius);

/// The maximal 2-connected subgraphs with two or more edges, most edges first, and the other edges.
struct Biconnected {
  std::vector<std::vector<EdgeId>> components;
  std::vector<EdgeId> dropped;
};
Biconnected biconnected_components(const Graph& graph);

/// The faces of a component, the unbounded one among them: chains grown from an edge at both ends,
/// by angle, until they close (TGW in the plane). Throws: Failure.
std::vector<Chain> minimal_cycles(const Graph& graph, std::span<const EdgeId> edges);

/// Which of the faces is the unbounded one: the only one with the vertices that are outermost in x
/// and y, or the first of these whose area is negative. Throws: Failure.
std::size_t unbounded_face(const Graph& graph, std::span<const EdgeId> edges,
                           std::span<const Chain> faces);

/// The area of a face by determinants of its corners where they are, from the corner that its first
/// edge leaves. Throws: Failure.
double face_area(const Graph& graph, const Chain& face);

/// Whether the point is inside of the edges, by parity, and not on one.
bool is_inside(const PointD& point, const Graph& graph, const Chain& edges);

/// Which components are holes of which faces: a component is in another one if its box is and one
/// of its vertices is inside of that one's shell, and in the first face whose box has its box.
/// Cost: O(c^2) for c components, and the edges of shells per pair of boxes.
std::vector<Hole> nest(const Graph& graph, std::span<const Component> components);

/// The stages after `merge`: fills in the rest of the trace. What fails is its failure.
void find_cells(Trace& trace);

}  // namespace plumbline::plasm

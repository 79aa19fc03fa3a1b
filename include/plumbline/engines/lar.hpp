#pragma once

#include <array>
#include <optional>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {
struct Engine;
}

/// The float pipeline of LAR's module `inters` (Paoluzzi, "Accelerated intersection of geometric
/// objects", November 2015), variant `repaired`: the best float version of the published algorithm.
/// Everything here is computed in doubles; nothing is exact. The stages are in `lar_stages.hpp`.
namespace plumbline::lar {

/// The publication's radius of 0.001 on a drawing scaled to the unit square.
inline constexpr double kDefaultRelativeRadius = 0.001;
/// A default radius is no longer than this part of the shortest segment: what is drawn, chords of
/// curves too, is not swallowed.
inline constexpr double kMostOfSegment = 0.25;
/// Least radius in units of the drawing's largest coordinate: 128 roundings. Below it, two floats
/// that stand for the same point could stay apart.
inline constexpr double kLeastRelativeRadius = 0x1p-46;
/// Most rounds of splitting and merging. 21,000 runs on small random drawings, many with features
/// below the radius, needed nine at most; real ones need two.
inline constexpr std::size_t kMaxRounds = 30;

struct Options {
  /// Vertices no further apart than this are merged (transitively), and an edge that passes a
  /// vertex no further than this is led through it. In drawing units; by default
  /// kDefaultRelativeRadius times the longer side of the drawing's `extent`, but no more than
  /// kMostOfSegment times its shortest segment; raised to kLeastRelativeRadius where it is less.
  std::optional<double> radius;
  /// At most so many (and 1024); 0: as many as there are cores. Does not change the result.
  std::size_t threads = 0;
};

using Box = std::array<double, 4>;  ///< xmin, ymin, xmax, ymax

using VertexPair = std::array<VertexId, 2>;  ///< an edge; two equal vertices are a point

/// A LAR model (V, FV, EV): cells as lists of vertices.
struct Model {
  std::vector<PointD> vertices;
  std::vector<VertexPair> edges;
  Lists<VertexId> faces;

  friend bool operator==(const Model&, const Model&) = default;
};

/// A graph (V, EV) in the plane. An isolated input point is an edge from its vertex to itself that
/// has no sources.
struct Graph {
  std::vector<PointD> vertices;
  std::vector<Edge> edges;
  Lists<SegmentId> edge_sources;  ///< per edge, ascending: the input segments that it is part of

  friend bool operator==(const Graph&, const Graph&) = default;
};

/// A place where an edge is cut: the parameter from tail (0) to head (1) and the point there.
struct Cut {
  double parameter = 0;
  PointD point;
};

/// What merging near vertices did.
struct Pruning {
  std::vector<PointD> vertices;      ///< after merging, ascending
  std::vector<VertexId> vertex_map;  ///< old vertex -> new vertex
  Lists<VertexId> clusters;          ///< the old vertices of each cluster of two or more
};

/// One round of splitting the edges of a graph and merging its vertices.
struct Round {
  std::vector<Box> boxes;  ///< per edge, grown by the radius
  Lists<EdgeId> buckets;   ///< final buckets
  Lists<Cut> cuts;         ///< per edge, ascending, none at its ends
  Graph split;             ///< before pruning
  Pruning pruning;
  Graph simplified;  ///< after pruning, without zero and double edges

  /// Nothing was cut or merged: no edges cross, no vertex is within the radius of another, or
  /// within 0.86 radii of an edge that it does not bound.
  bool idle() const { return cuts.flat().empty() && pruning.clusters.size() == 0; }
};

/// The output of every stage.
struct Trace {
  double radius = 0;  ///< in drawing units
  /// Whether that is kMostOfSegment times the shortest segment, since nobody chose.
  bool radius_from_segment = false;
  /// The coordinates of all stages are the drawing's divided by 2^exponent; 0 unless the largest is
  /// beyond 2^+-100.
  int exponent = 0;
  Graph drawing;              ///< the distinct segments in doubles, and the isolated points
  std::vector<Round> rounds;  ///< the first is the publication's; repeated until one is idle
  bool settled = false;  ///< whether the last round was idle; if not, kMaxRounds were not enough
  Lists<EdgeId> biconnected;        ///< components of two or more edges
  std::vector<EdgeId> bridges;      ///< edges in no cycle (dangling edges too)
  Lists<HalfedgeId> edge_order;     ///< per vertex the halfedges that leave it, by angle
  Lists<HalfedgeId> cycles;         ///< of the face walk over the last round's simplified graph
  std::vector<double> cycle_areas;  ///< signed
};

struct Result {
  FloatComplex complex;  ///< in canonical order
  Trace trace;
};

/// The 2-complex that the float LAR pipeline makes of the segments. **Rounded** at every step.
/// Degenerate: what is shorter than the radius vanishes or closes; empty input gives the unbounded
/// face alone; dangling edges and bridges stay, as antennas; isolated points off all edges stay.
/// **Heuristic**: features smaller than the radius may be lost, and where rounds do not settle the
/// result may be no valid complex (crossing edges, wrong nesting): `validate(exact(complex))`
/// tells. Order: canonical; the complex does not depend on the order, direction or repetition of
/// the segments (SegmentIds in `edge_sources` aside); it may depend on where the drawing lies and
/// how it is turned or mirrored. Cost: O(n log n + pairs that share a bucket) per round. Throws:
/// Error BadInput for a radius that is negative or not finite, or a coordinate beyond the largest
/// double; Limit where edges cut each other in more than 2^26 places (kMaxCuts of lar_stages.hpp).
Result arrange(const SegmentSet& input, const Options& options = {});

/// The same as an engine for `check`, with the parameter radius; its name is "lar".
Engine engine();

/// The model with vertices no further apart than the radius (raised as above) merged, transitively,
/// into their centroids. Edges of fewer than two and faces of fewer than three vertices, repeated
/// cells and unused vertices are dropped. Order: vertices and edges ascending; faces as they were,
/// each with its vertices as they were. **Heuristic**: faces thinner than the radius may overlap
/// then. Requires: finite vertices. Section 2.9 (larSimplify). Throws: Error BadInput for a radius
/// that is negative or not finite, or a cell with a vertex that the model has not.
Model simplify(const Model& model, double radius);

/// The boundary of a bounded face as one closed polyline, its cycles joined by `bridge_edges`,
/// every bridge walked twice; the face on its left. Section 2.7. Throws: as `bridge_edges`.
std::vector<PointD> single_polyline(const FloatComplex& complex, FaceId face);

/// The drawing mapped onto the unit square: the longer side of its box becomes 1, the left edge 0,
/// the top 1; y is turned upwards. **Exact**. Degenerate: a drawing without extent is only moved.
/// Section 4 (SVG input normalization).
SegmentSet to_unit_square(const SegmentSet& input);

}  // namespace plumbline::lar

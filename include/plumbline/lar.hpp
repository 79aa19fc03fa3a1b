#pragma once

#include <array>
#include <optional>
#include <vector>

#include "plumbline/complex.hpp"

/// The float pipeline of LAR's module `inters` (Paoluzzi, "Accelerated intersection of geometric
/// objects", November 2015), variant `repaired`: the best float version of the published algorithm.
/// Everything here is computed in doubles; nothing is exact. The stages are in `lar/stages.hpp`.
namespace plumbline::lar {

/// The publication's radius of 0.001 on a drawing scaled to the unit square.
inline constexpr double kDefaultRelativeRadius = 0.001;

struct Options {
  /// Vertices no further apart than this are merged (transitively). In drawing units; by default
  /// kDefaultRelativeRadius times the longer side of the drawing's box.
  std::optional<double> radius;
};

using Box = std::array<double, 4>;  ///< xmin, ymin, xmax, ymax

/// A segment with double ends.
struct SegmentD {
  PointD a;
  PointD b;
  friend bool operator==(const SegmentD&, const SegmentD&) = default;
};

/// The graph of split segments: points and edges as pairs of point indices, each with its sources.
struct Graph {
  std::vector<PointD> vertices;
  std::vector<Edge> edges;
  std::vector<std::vector<SegmentId>> edge_sources;
};

/// What merging near vertices did.
struct Pruning {
  std::vector<PointD> vertices;                 ///< after merging
  std::vector<VertexId> vertex_map;             ///< old vertex -> new vertex
  std::vector<std::vector<VertexId>> clusters;  ///< the old vertices of each cluster of two or more
};

/// The output of every stage.
struct Trace {
  double radius = 0;
  std::vector<SegmentD> segments;               ///< rounded to nearest doubles
  std::vector<Box> boxes;                       ///< per segment
  std::vector<std::vector<SegmentId>> buckets;  ///< final buckets
  std::vector<std::vector<double>> parameters;  ///< per segment, ascending, in (0, 1)
  Graph split;                                  ///< 1-complex before pruning
  Pruning pruning;
  Graph simplified;                              ///< after pruning, without zero and double edges
  std::vector<std::vector<EdgeId>> biconnected;  ///< components of two or more edges
  std::vector<EdgeId> bridges;                   ///< edges in no cycle (dangling edges too)
  std::vector<std::vector<HalfedgeId>> cycles;   ///< of the face walk over `simplified`
  std::vector<double> cycle_areas;               ///< signed
};

struct Result {
  FloatComplex complex;  ///< in canonical order
  Trace trace;
};

/// The 2-complex that the float LAR pipeline makes of the segments. **Rounded** at every step.
/// Degenerate: zero-length segments (after rounding) vanish; empty input gives the unbounded face
/// alone; dangling edges and bridges stay, as antennas; the result may be no valid complex
/// (crossing edges, wrong nesting): `validate(exact(result.complex))` tells. Order: canonical.
/// Cost: about O(n log n + pairs that share a bucket). Throws: Error BadInput for a radius that is
/// negative or not finite, or a coordinate beyond the largest double.
Result arrange(const SegmentSet& input, const Options& options = {});

}  // namespace plumbline::lar

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plumbline/arrange.hpp"
#include "plumbline/complex.hpp"

namespace plumbline {

/// The numbers that coordinates are rounded to.
struct Grid {
  std::optional<int> decimals;  ///< N: the multiples of 10^-N; none: doubles

  static constexpr int kMaxDecimals = Number::kMaxDigits;
  friend bool operator==(const Grid&, const Grid&) = default;
};
/// "nearest doubles", "3 decimals".
std::string to_text(const Grid& grid);

enum class RoundingMethod {
  NearestDoubles,  ///< every coordinate to the nearest double, ties to even
  NearestPoints,   ///< every vertex to the nearest point of a uniform grid, ties upwards
  SnapRounded,     ///< the same, and edges led through the grid points that they come near
};

/// A complex whose coordinates are numbers of a grid, and how it follows from the exact one.
struct Rounding {
  RoundingMethod method = RoundingMethod::NearestDoubles;
  Rational spacing;      ///< of the uniform grid; of NearestDoubles the largest between two of them
  ExactComplex complex;  ///< rounded; its sources are the segments that cover the exact edges
  std::vector<VertexId> vertex_image;  ///< per exact vertex
  Lists<HalfedgeId> edge_image;        ///< per exact edge from tail to head; empty: it vanished
  std::vector<FaceId> face_origin;     ///< per rounded face the exact face that it is (a part) of
  /// Whether a reader that takes the coordinates as doubles has a valid complex with the same
  /// incidences: `is_kept_by_simple_rounding`.
  bool valid_as_doubles = true;

  /// Whether vertices, edges and faces correspond one to one, with all their incidences.
  bool has_same_incidences() const { return method != RoundingMethod::SnapRounded; }
};

/// The complex with rounded coordinates, proven to be a valid one. First every vertex goes to the
/// nearest point of the grid; where that is no valid complex with the same incidences, snap
/// rounding (Greene and Yao 1986; Hobby 1999; Guibas and Marimont 1998): the unit square around
/// each grid point that a vertex goes to is a hot pixel, and every edge becomes the chain of
/// the centres of the hot pixels that it meets. Doubles are no uniform grid; if the nearest
/// ones will not do, the multiples of the distance of doubles at the largest coordinate take their
/// place, which are doubles too. Pixels are half-open, [-1/2, 1/2) of the spacing in x and y: the
/// proofs need pixels of one shape, and points at least one spacing apart stay apart. So ties
/// go upwards on uniform grids.
///
/// Guaranteed, and the first five verified before it returns (`ensure_rounded`), all **exact**:
/// - Grid: every coordinate is a number of the grid.
/// - Movement: in x and in y, no vertex moves by more than spacing / 2; an edge's image, walked
///   from end to end, stays within spacing / 2 of the edge, walked at some pace.
/// - Planarity: `validate` finds nothing; no vertex is in the interior of an edge.
/// - Topology is kept up to merging: nothing gets into another face. Vertices merge, edges vanish
///   or merge or bend at vertices, faces vanish or fall into parts, and nothing else happens.
/// - Sides: no vertex goes past an edge, whatever the faces: one above an edge, its x between those
///   of the ends, is then above the edge's image or on it, and one below it below or on it.
/// - Nothing moves without need: a complex that simple rounding keeps is simply rounded.
/// - Idempotence: what this returned is rounded to itself, with the same incidences.
/// - Determinism: the result depends on the complex and the grid alone; it is in canonical order.
///
/// Not guaranteed: a distance between vertices and edges; that a mirrored complex has the mirrored
/// result.
///
/// Requires: a valid complex in canonical order, coordinates within kMaxCoordinateBits. Degenerate:
/// a component that falls into one pixel becomes an isolated vertex. Cost: O(n log n) where simple
/// rounding will do; else O((n + k) log n) expected for n cells and k pairs of an edge and a hot
/// pixel near it. Throws: Error BadInput for decimals beyond 0..kMaxDecimals; Limit; Internal if
/// the verification finds anything.
Rounding safely_rounded(const ExactComplex& complex, const Grid& grid,
                        const ArrangeOptions& options = {});

/// Whether the complex with every vertex simply rounded (to nearest doubles, ties to even; to
/// decimals, ties upwards) is a valid complex with the same incidences, and no vertex went past an
/// edge. **Exact**. Requires and throws: as above.
bool is_kept_by_simple_rounding(const ExactComplex& complex, const Grid& grid);

/// Checks every guarantee above of a rounding of `complex` but the last three, anew. Throws: Error
/// Internal, with the first one broken and its place.
void ensure_rounded(const ExactComplex& complex, const Grid& grid, const Rounding& rounding);

/// What a rounding did, cell by cell, ascending. Edges and faces without name here correspond one
/// to one. All distances are **exact** and at most half a diagonal of a pixel.
struct RoundingChanges {
  struct Movement {
    VertexId vertex;  ///< of the exact complex; `vertex_image` tells whereto
    Rational squared_distance;
  };
  struct MergedVertices {
    VertexId into;               ///< of the rounded complex
    std::vector<VertexId> from;  ///< of the exact complex, two or more
  };
  struct MergedEdges {
    EdgeId into;
    std::vector<EdgeId> from;
  };
  struct Bend {
    EdgeId edge;                ///< of the exact complex
    Rational squared_distance;  ///< of the vertices inside its image from it, the largest
  };
  struct SplitFace {
    FaceId face;  ///< of the exact complex
    std::vector<FaceId> into;
  };

  std::vector<Movement> moved_vertices;
  std::vector<MergedVertices> merged_vertices;
  std::vector<MergedEdges> merged_edges;
  std::vector<Bend> bent_edges;
  std::vector<EdgeId> vanished_edges;
  std::vector<FaceId> vanished_faces;
  std::vector<SplitFace> split_faces;

  /// 0 where nothing moved, and where nothing is bent.
  Rational largest_squared_movement() const;
  Rational largest_squared_bend() const;
};
RoundingChanges changes(const ExactComplex& complex, const Rounding& rounding);

}  // namespace plumbline

#pragma once

#include <array>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {

/// A face as most programs write it: its outer boundary and its holes as rings of vertices.
struct Polygon {
  std::vector<VertexId> outer;
  std::vector<std::vector<VertexId>> holes = {};
};

/// The cells of a result as someone else lists them, right or wrong.
struct CellLists {
  std::vector<PointD> vertices;
  std::vector<std::array<VertexId, 2>> edges;
  std::vector<Polygon> faces;  ///< bounded ones
  /// Whether `edges` lists all edges, as LAR's EV does. If not, a side of a face that is not listed
  /// is an edge as well.
  bool lists_all_edges = false;
};

/// The complex that the lists describe, in canonical order, for `validate` and `comparison`: what
/// is wrong in the lists is wrong in the complex. Repeated vertices and edges, edges that cross,
/// faces that overlap (a halfedge in the cycles of several faces) or leave gaps (a cycle of no
/// face) stay as they are. What such lists do not say is filled in, and only that:
/// - Rings have either orientation: outer ones are turned counter-clockwise, holes clockwise (by
///   exact area; a ring of area 0 is not turned). A vertex that follows itself counts once, so
///   rings may repeat their first vertex.
/// - Rings of one face that meet in a vertex are joined or parted there, as cycles are that keep
///   the face on their left.
/// - Edges in no ring that lie inside one face alone become its antennas or, apart from its rings,
///   its holes; vertices of no edge become its isolated vertices.
/// - The outline of what lies in no face, and no gap, becomes a hole of the unbounded face.
/// So a cycle without face is a gap, or a hole that the face around it does not list and covers.
/// Where `lists_all_edges`, a side of a face that is no edge is left out (the cycle jumps), and so
/// is a face of such sides alone. Edges have no sources. Requires: finite coordinates. Cost: as
/// `validate`. Throws: Error BadInput for a vertex that is not there.
FloatComplex complex_from_faces(const CellLists& cells);

}  // namespace plumbline

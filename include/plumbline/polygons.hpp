#pragma once

#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {

/// A face as a polygon: rings of vertices, the first one not repeated at the end. The outer one
/// runs counter-clockwise, holes clockwise. Each ring is simple; two rings have a point in common
/// at most, so that GEOS, JTS and everybody who keeps to "Simple features" call it valid.
struct FacePolygon {
  FaceId face;
  std::vector<VertexId> outer;
  Lists<VertexId> holes;
  std::vector<EdgeId> antennas;  ///< left out of the rings: edges with the face on both sides

  friend bool operator==(const FacePolygon&, const FacePolygon&) = default;
};

/// The bounded faces of a complex as polygons: antennas and isolated vertices left out, boundaries
/// that touch themselves parted there. What they cover is the face, point by point, but for its
/// antennas and isolated vertices. **Exact**. Requires: a valid complex. Order: by face; each ring
/// begins at its least vertex, holes are ascending by it, and by the next ones where they begin in
/// one vertex. Cost: linear, and O(k log k) for k vertices of a face. Throws: Error Internal for an
/// invalid complex, where that is noticed.
std::vector<FacePolygon> polygons(const ExactComplex& complex);

/// A face next to another one, and the length of what bounds both.
struct Neighbour {
  FaceId face;
  double length = 0;  ///< **Rounded**

  friend bool operator==(const Neighbour&, const Neighbour&) = default;
};

/// Per face (the unbounded one, too) the faces that an edge parts it from, ascending. Faces that
/// touch in points alone are no neighbours. Cost: O(E log E).
std::vector<std::vector<Neighbour>> neighbours(const ExactComplex& complex);

/// Per face the input segments that its boundary and its antennas lie on, ascending.
/// Cost: O(k log k) for k sources of edges.
std::vector<std::vector<SegmentId>> face_sources(const Incidences& complex);

/// Per face the length of its boundary, antennas left out. **Rounded**: a sum of nearest doubles in
/// the order of edges.
std::vector<double> perimeters(const ExactComplex& complex);

}  // namespace plumbline

#pragma once

#include <array>

#include "read/dxf/shapes.hpp"

namespace plumbline::dxf {

/// A VERTEX record of a POLYLINE.
struct PolylineVertex {
  NumberPoint point;
  Number bulge;
  std::int64_t flags = 0;
  std::array<std::int64_t, 4>
      face{};  ///< of a polyface mesh: vertices from 1, negative: hidden edge
};

/// A POLYLINE record and the VERTEX records that follow it.
struct Polyline {
  std::int64_t flags = 0;
  std::int64_t smoothing = 0;
  std::int64_t rows = 0, columns = 0;  ///< of a polygon mesh
  Plane plane = Plane::Front;
  std::vector<PolylineVertex> vertices;
};

/// Throws: Unusable.
Polyline polyline_of(const Entity& entity);
PolylineVertex polyline_vertex_of(const Entity& entity);

/// Lines and arcs of a polyline in the plane or in space, the grid of a polygon mesh, the outlines
/// of the faces of a polyface mesh (a common edge once for each). Frames of fitted curves are
/// `refused`. Throws: Unusable.
DrawnEntity draw_polyline(const Polyline& polyline, Pen& pen);

}  // namespace plumbline::dxf

#pragma once

#include <array>
#include <span>
#include <vector>

#include "engines/lar/show/scene.hpp"

namespace plumbline::svg {

/// The faces that solid pictures show, of either variant. Repaired: those of the complex.
/// Published: the cells of the containment lattice, or, where there is none, the faces of the
/// result.
std::vector<LarScene::Polygon> solid_faces(const lar::Result& result);
std::vector<LarScene::Polygon> solid_faces(const inters::Trace& trace);

using TriangleD = std::array<PointD, 3>;
/// Per face the triangles that fill it; none where its edges cross.
std::vector<std::vector<TriangleD>> fillings(const lar::Result& result);
std::vector<std::vector<TriangleD>> fillings(const inters::Trace& trace);

/// Per face its boundary as closed polylines, and the bridge edges that join its cycles. Repaired:
/// one polyline, every bridge walked twice. Published: the bridges as published.
struct Bridged {
  std::vector<std::vector<PointD>> polylines;
  std::vector<std::array<PointD, 2>> bridges;
};
std::vector<Bridged> bridged(const lar::Result& result);
std::vector<Bridged> bridged(const inters::Trace& trace);

/// The edges that bound a chain of faces. Throws: Error BadInput for a face that is not there.
std::vector<std::array<PointD, 2>> boundary(const lar::Result& result,
                                            std::span<const std::size_t> faces);
std::vector<std::array<PointD, 2>> boundary(const inters::Trace& trace,
                                            std::span<const std::size_t> faces);

}  // namespace plumbline::svg

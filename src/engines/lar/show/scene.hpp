#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::svg {

using TriangleD = std::array<PointD, 3>;
using EndsD = std::array<PointD, 2>;

/// The boundary of a face as closed polylines, and the bridge edges that join its cycles.
struct Bridged {
  std::vector<std::vector<PointD>> polylines;
  std::vector<EndsD> bridges;
};

/// What pictures of a run of a LAR pipeline show, in drawing units.
struct Scene {
  struct Line {
    PointD a, b;
    std::size_t bucket;  ///< the first that holds it; its own number for a line in none
  };
  using Polygon = std::vector<std::vector<PointD>>;  ///< outer boundary, then holes

  std::vector<Line> lines;  ///< the input
  std::vector<PointD> vertices;
  std::vector<std::array<VertexId, 2>> edges;
  std::vector<std::vector<std::array<VertexId, 2>>> components;  ///< biconnected
  std::vector<std::array<VertexId, 2>> bridges;
  std::vector<Polygon> faces;
  std::vector<PointD> unpruned;                 ///< vertices before merging
  std::vector<std::vector<VertexId>> clusters;  ///< of them
  std::vector<PointD> centroids;                ///< per cluster
  double radius = 0;

  // What only solid pictures show.
  std::vector<Polygon> solid_faces;
  /// Per solid face the triangles that fill it; none where its edges cross.
  std::function<std::vector<std::vector<TriangleD>>()> fillings;
  /// Per solid face.
  std::function<std::vector<Bridged>()> bridged;
  /// The edges that bound a chain of solid faces. Requires: there are such faces.
  std::function<std::vector<EndsD>(std::span<const std::size_t> chain)> boundary;
};

/// The corners of a cycle.
std::vector<PointD> points(std::span<const PointD> vertices, std::span<const VertexId> cycle);
/// The lists, each on its own.
std::vector<std::vector<VertexId>> vectors(const Lists<VertexId>& lists);
/// The triangles that fill a face; none where the complex is not valid there.
std::vector<TriangleD> filling(const ExactComplex& complex, FaceId face);

}  // namespace plumbline::svg

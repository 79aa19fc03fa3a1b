#pragma once

#include <array>
#include <vector>

#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/lar.hpp"

namespace plumbline::svg {

/// What pictures of the float pipeline show, of either variant.
struct LarScene {
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
};

/// In drawing units. The clusters are those of the first round.
LarScene scene(const lar::Result& result);
LarScene scene(const inters::Trace& trace);

}  // namespace plumbline::svg

#pragma once

#include <cstdint>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// The lines and polygons of a file, coordinates rounded to nearest doubles.
struct Geometries {
  struct Polygon {
    std::vector<std::vector<PointD>> rings;  ///< the outer one first
  };
  std::vector<std::vector<PointD>> lines;
  std::vector<Polygon> polygons;
};

}  // namespace plumbline

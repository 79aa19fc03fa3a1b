#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plumbline/structure.hpp"

namespace plumbline {

/// The lines and polygons of a file, coordinates rounded to nearest doubles.
struct Geometries {
  struct Polygon {
    std::vector<std::vector<PointD>> rings;  ///< the outer one first
  };
  std::vector<std::vector<PointD>> lines;
  std::vector<Polygon> polygons;
};

/// How a format without hierarchy is read.
struct FeatureOptions {
  Geometries* geometries = nullptr;       ///< where lines and polygons go; none: to the Structure
  std::size_t max_segments = kAnyNumber;  ///< of the Structure
  bool shortest_decimals = false;         ///< as ReadOptions has it, and what follows
  std::vector<std::string> layers = {}, without_layers = {};
  std::string layer_property = "layer";
};

}  // namespace plumbline

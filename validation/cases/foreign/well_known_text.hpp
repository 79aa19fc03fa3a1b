#pragma once

#include <string_view>
#include <vector>

#include "cases/foreign/paths.hpp"

namespace plumbline::foreign {

/// A geometry with its structure, which segments alone do not have. Empty rings and polygons are
/// left out.
struct Geometry {
  Path points;
  std::vector<Path> lines;
  std::vector<Path> rings;                  ///< those that are geometries by themselves
  std::vector<std::vector<Path>> polygons;  ///< each the rings of one polygon, its shell first
  std::vector<Geometry> parts;
};

/// The area of all polygons, by their shells less their holes. **Exact**.
Rational area(const Geometry& geometry);
/// The length of their rings. **Rounded**.
double perimeter(const Geometry& geometry);

/// Well-known text of two dimensions. Throws: Error BadInput.
Geometry geometry(std::string_view text);

}  // namespace plumbline::foreign

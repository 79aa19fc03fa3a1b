#pragma once

#include "plumbline/features.hpp"

namespace plumbline::features {

inline FeatureValue number(std::size_t value) { return static_cast<std::int64_t>(value); }

inline std::vector<PointD> places(const ExactComplex& complex, std::span<const VertexId> ring) {
  std::vector<PointD> result;
  result.reserve(ring.size());
  for (const VertexId v : ring) result.push_back(complex.vertices.nearest(v));
  return result;
}

/// The rings of a polygon.
inline std::vector<std::vector<PointD>> parts(const ExactComplex& complex,
                                              const FacePolygon& polygon) {
  std::vector<std::vector<PointD>> result{places(complex, polygon.outer)};
  for (std::size_t h = 0; h < polygon.holes.size(); ++h) {
    result.push_back(places(complex, polygon.holes[h]));
  }
  return result;
}

}  // namespace plumbline::features

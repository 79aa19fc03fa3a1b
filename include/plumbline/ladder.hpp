#pragma once

#include <cstddef>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {

/// A critical radius: from it on (it included) merging within the radius gives other numbers of
/// cells.
struct LadderStep {
  Rational squared_radius;                         ///< exact
  std::size_t vertices = 0, edges = 0, faces = 0;  ///< from here on; faces with the unbounded one
  /// What is that near: two vertices, or a vertex and an edge that it does not bound.
  VertexId vertex;
  VertexId other_vertex;  ///< invalid where an edge is near
  EdgeId edge;            ///< invalid where two vertices are near
};

/// How a drawing falls together as the tolerance grows.
struct ToleranceLadder {
  std::size_t vertices = 0, edges = 0, faces = 0;  ///< at radius 0: those of the complex
  std::vector<LadderStep> steps;                   ///< ascending
  bool is_complete = true;  ///< whether it goes on until nothing changes any more
};

/// The radii for which the float pipeline's result is right, as far as they were tried.
struct RightRadii {
  double least = 0;
  double largest = 0;
};

}  // namespace plumbline

#pragma once

#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::round_steps {

/// The places that vertices are rounded to: distinct, in the order of vertices.
struct Places {
  std::vector<Point> points;
  std::vector<VertexId> of_vertex;  ///< per vertex the index of its place
};

/// Requires: per vertex, in canonical order, where it goes; x ascending (so it is where rounding
/// is monotone).
Places distinct(std::vector<Point> places);

}  // namespace plumbline::round_steps

#pragma once

// Step 7: the cycles that the halfedges form. On one thread: it is a few percent of the work.

#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::bucket {

/// Cycles, numbered by their least halfedges.
struct Cycles {
  std::vector<CycleId> of_halfedge;
  std::vector<HalfedgeId> first;  ///< per cycle, its least halfedge
};

Cycles walk_cycles(const std::vector<HalfedgeId>& next);

}  // namespace plumbline::bucket

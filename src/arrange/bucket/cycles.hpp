#pragma once

// Step 7: the cycles that the halfedges form.

#include <span>
#include <vector>

#include "arrange/bucket/job.hpp"
#include "plumbline/complex.hpp"

namespace plumbline::bucket {

/// Cycles, numbered by their least halfedges.
struct Cycles {
  std::vector<CycleId> of_halfedge;
  std::vector<HalfedgeId> first;  ///< per cycle, its least halfedge
};

Cycles walk_cycles(const std::vector<HalfedgeId>& next, Job& job);

}  // namespace plumbline::bucket

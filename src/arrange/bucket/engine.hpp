#pragma once

#include <variant>

#include "arrange/bucket/faces.hpp"
#include "arrange/bucket/filtered_kernel.hpp"
#include "arrange/bucket/grid_kernel.hpp"

namespace plumbline::bucket {

using AnyKernel = std::variant<GridKernel, FilteredKernel>;

/// Everything that the engine found out, by implicit vertices.
struct Result {
  AnyKernel kernel;
  Provenance provenance;
  std::vector<Crossing> crossings;
  Chains chains;
  std::vector<LineId> edge_line;
  std::vector<HalfedgeId> next;
  Cycles cycles;
  Faces faces;
  std::size_t component_count = 0;
};

Result arrange(const SegmentSet& input, Job& job);

}  // namespace plumbline::bucket

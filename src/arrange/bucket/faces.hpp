#pragma once

// Step 8, continued: faces from cycles.

#include <vector>

#include "arrange/bucket/nest.hpp"

namespace plumbline::bucket {

/// Face 0 is unbounded; the others are numbered as their outer cycles.
struct Faces {
  std::vector<FaceId> of_cycle;
  std::vector<CycleId> outer;
  Grouped<CycleId> holes;               ///< per face
  Grouped<VertexId> isolated_vertices;  ///< per face
};

/// Every cycle is the outer boundary of a face, save the one around a component, which is a hole of
/// the face that the component lies in.
Faces make_faces(const Cycles& cycles, const std::vector<Component>& components);

}  // namespace plumbline::bucket

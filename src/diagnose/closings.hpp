#pragma once

#include <optional>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline::diagnose_steps {

/// A line that would join what is near each other.
struct Closing {
  std::size_t number;  ///< of the defect that it mends
  Point a, b;
};

/// For each of `count` defects the area of the lesser one of two faces that its closings part, all
/// closings being drawn; of several the largest, none where they part nothing. Faces of the drawing
/// that are parted are those that its gaps leave open. **Rounded**. Cost: an arrangement.
std::vector<std::optional<double>> open_areas(const SegmentSet& input,
                                              const std::vector<Closing>& closings,
                                              std::size_t count);

}  // namespace plumbline::diagnose_steps

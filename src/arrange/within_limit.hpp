#pragma once

#include "plumbline/geometry.hpp"

namespace plumbline {

/// Throws: Error Limit for a coordinate beyond kMaxCoordinateBits.
void ensure_within_limit(const SegmentSet& input);

}  // namespace plumbline

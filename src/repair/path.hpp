#pragma once

#include <vector>

#include "plumbline/edits.hpp"

namespace plumbline::repair_steps {

/// The lines of a path over points, one for what goes straight on; points that are the same make
/// none.
std::vector<Line> lines_along(const std::vector<Point>& path,
                              const std::vector<SegmentId>& segments);

}  // namespace plumbline::repair_steps

#pragma once

#include <vector>

#include "plumbline/edits.hpp"

namespace plumbline::repair_steps {

/// The lines of a path over points, as few as cover it; points that are the same, and ways back,
/// make none.
std::vector<Line> lines_along(const std::vector<Point>& path,
                              const std::vector<SegmentId>& segments);

}  // namespace plumbline::repair_steps

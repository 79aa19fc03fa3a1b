// Rings of the closed walks that go around the faces of a planar graph, the face on the left.
#pragma once

#include "adapter.hpp"

namespace study {

// The rings that are left of a walk where the edges that it passes twice, which bound nothing, are
// taken out. The first one encloses the others, if any of them has the face within it.
std::vector<Ring> rings_of_walk(const Ring& walk, const std::vector<Point>& vertices);

}  // namespace study

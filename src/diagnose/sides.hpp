#pragma once

#include <cstdint>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline::diagnose_steps {

/// On which side of a segment, seen from its lexicographically first end, the shape lies of whose
/// outline it is a side.
enum class Side : unsigned char { Unknown, Left, Right };

/// A side, and of which polygon.
struct SideOf {
  Side side = Side::Unknown;
  std::uint32_t polygon = 0;
};

/// Per segment; Unknown for what is no side of a closed ring with an area. **Exact**.
std::vector<SideOf> sides_of(const SegmentSet& input);

/// Whether two polygons lie on the two sides.
inline bool are_neighbours(const SideOf& a, const SideOf& b) {
  return a.side != Side::Unknown && b.side != Side::Unknown && a.side != b.side &&
         a.polygon != b.polygon;
}

}  // namespace plumbline::diagnose_steps

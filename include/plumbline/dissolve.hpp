#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plumbline/regions.hpp"

namespace plumbline {

/// What the regions of each group cover together: of those of one number, from 0, all points that
/// lie in any. **Exact**. Edges know the segments of their group that they lie on. Requires: a
/// group for each region of `input`. Degenerate: nothing for a number that no region has. Cost: as
/// `arrange` of each group. Throws: as `arrange`, `label`.
std::vector<RegionPolygons> dissolve(const SegmentSet& input, const std::vector<Region>& regions,
                                     std::span<const std::uint32_t> groups,
                                     std::size_t threads = 0);

/// The polygons as a drawing, an item each, to go on with. **Exact**. Cost: linear.
SegmentSet drawing_of(const RegionPolygons& regions);

}  // namespace plumbline

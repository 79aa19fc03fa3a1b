#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "plumbline/read.hpp"

namespace plumbline::tiles {

/// Visits the segments of a drawing in pieces, as `read` and `evaluate` make them in one. Of a
/// regular `.lines` file no more is in memory than a piece; of the others all of it. Returns what
/// was rejected.
std::vector<Rejected> for_each_piece(const std::filesystem::path& drawing,
                                     const ReadOptions& options,
                                     const std::function<void(const SegmentSet&)>& visit);

}  // namespace plumbline::tiles

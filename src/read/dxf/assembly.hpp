#pragma once

#include <string>

#include "read/dxf/space.hpp"

namespace plumbline::dxf {

/// Most rows and columns that the arrays of a drawing may have in all.
inline constexpr std::size_t kMaxArrayItems = std::size_t{1} << 22U;

/// The hierarchy below the model space: each block, and each layer of it, is a Struct stored once.
/// What a block has on layer "0" is in its own Struct, so it lies on the layer of each insert.
/// Takes the models out of the drawing; inserts of blocks that are not there are passed over.
/// Throws: Error Limit for arrays of more than kMaxArrayItems rows and columns. Requires: no
/// cycles.
Structure assemble(Drawing& drawing, const std::string& file_name);

}  // namespace plumbline::dxf

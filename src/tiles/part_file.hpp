#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "plumbline/tiles.hpp"

namespace plumbline::tiles {

/// The bytes of a part of these segments.
std::string to_bytes(const StripPart& part, const CellHash& segments);
/// None where the bytes are not whole, or of other segments.
std::optional<StripPart> from_bytes(std::string_view bytes, const CellHash& segments);

}  // namespace plumbline::tiles

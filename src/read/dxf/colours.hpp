#pragma once

#include <cstdint>
#include <optional>

namespace plumbline::dxf {

/// AutoCAD's colour of this number from 1 to 255 as 0xRRGGBB. None for others and for 7, which is
/// black or white as the paper is not.
std::optional<std::uint32_t> rgb_of_colour(std::int64_t number);

}  // namespace plumbline::dxf

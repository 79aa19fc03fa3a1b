#pragma once

#include <cstdint>
#include <optional>

namespace plumbline {

/// AutoCAD's colour of this number from 1 to 255 as 0xRRGGBB. None for others and for 7, which is
/// black or white as the paper is not.
std::optional<std::uint32_t> rgb_of_colour(std::int64_t number);

/// The number of the nearest of these colours, the least of them; 7 for black, and for none.
std::int64_t colour_number(const std::optional<std::uint32_t>& rgb);

}  // namespace plumbline

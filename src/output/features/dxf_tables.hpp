#pragma once

#include <cstdint>
#include <optional>

#include "plumbline/number.hpp"

namespace plumbline::features {

/// The colour index of what is white on black and black on white.
inline constexpr int kWhiteOrBlack = 7;

/// AutoCAD's colour index that is nearest to a colour 0xRRGGBB, the least of them; of none, and of
/// black, white or black.
int colour_index(const std::optional<std::uint32_t>& rgb);

/// $INSUNITS of a unit of so many metres; 0 where it has none.
int unit_number(const Rational& metres);

}  // namespace plumbline::features

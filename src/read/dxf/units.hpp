#pragma once

#include <optional>
#include <string_view>

#include "plumbline/number.hpp"

namespace plumbline::dxf {

/// The drawing unit by the value of $INSUNITS: **exact** but for the parsec, which is no rational
/// number of metres and rounded to one. None for 0, "unitless", and for what is no such code.
std::optional<LengthUnit> unit_of(std::string_view insunits);

}  // namespace plumbline::dxf

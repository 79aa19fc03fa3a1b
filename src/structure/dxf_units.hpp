#pragma once

#include <cstdint>
#include <optional>

#include "plumbline/number.hpp"

namespace plumbline {

/// The drawing unit by the code that $INSUNITS of DXF has for it: **exact** but for the parsec,
/// which is no rational number of metres and rounded to one. None for 0, "unitless", and for what
/// is no such code.
std::optional<LengthUnit> unit_of_code(std::int64_t code);
/// The first code of a unit of so many metres; 0 where there is none.
std::int64_t code_of_unit(const Rational& metres);

}  // namespace plumbline

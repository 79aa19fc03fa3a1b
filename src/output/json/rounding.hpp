#pragma once

#include "output/json/writer.hpp"
#include "plumbline/round.hpp"

namespace plumbline::json {

/// The member "rounding". Documented in docs/json.md.
Part rounding_member(const ExactComplex& exact, const Grid& grid, const Rounding& rounding);

}  // namespace plumbline::json

#pragma once

#include "plumbline/number.hpp"

namespace plumbline::features {

/// $INSUNITS of a unit of so many metres; 0 where it has none.
int unit_number(const Rational& metres);

}  // namespace plumbline::features

#pragma once

#include <string>

#include "plumbline/check.hpp"

namespace plumbline {

/// A distance by its square: exact where that is short, and rounded, "0.25", "sqrt(2) = 1.41421".
std::string distance_text(const Rational& squared);

/// The paragraph of the report that `advised` filled; "" if there is no advice.
std::string advice_text(const Check& check, std::size_t limit);

}  // namespace plumbline

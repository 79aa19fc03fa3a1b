#pragma once

#include "plumbline/number.hpp"

namespace plumbline {

/// Texts of as many digits are what a program printed of a double; shorter ones a person's choice.
inline constexpr std::int64_t kLeastLongMantissa = 100'000'000'000;  // 12 digits

/// Whether the number is given by a text of 12 digits or more.
bool is_long(const Number& value);
/// How far a number may lie from what its text was rounded from: half a unit of the last digit for
/// a long one; a short one is exact as written: 0.
double half_unit(const Number& value);

}  // namespace plumbline

#pragma once

#include "plumbline/number.hpp"

namespace plumbline {

/// A short decimal has at most so many digits.
inline constexpr int kShortDigits = 12;
/// A few operations in doubles leave an error of so many units in the last place of their result,
/// where numbers up to eight times as large were subtracted. Of numbers that have nothing to do
/// with short decimals one in 280 lies that near to one, or less.
inline constexpr double kDriftOfPrograms = 8;

/// The short decimal that a double was meant to be, if the number lies within kDriftOfPrograms of
/// one: 420.34 for 420.34000000000003; else the number as it is.
Number short_decimal(const Number& value);

}  // namespace plumbline

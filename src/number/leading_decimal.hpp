#pragma once

#include <cstdint>
#include <string_view>

#include "plumbline/number.hpp"

namespace plumbline {

/// A plain decimal at the beginning of a text: [+-] (digits [. [digits]] | . digits), of at most
/// Number::kMaxDigits digits.
struct LeadingDecimal {
  Number value;
  std::size_t length = 0;  ///< of its text; 0 where there is none
};

/// The longest one. What follows it is not looked at, so it may be the beginning of another number
/// ("1e3", "1/3").
inline LeadingDecimal leading_decimal(std::string_view text) {
  const char* p = text.data();
  const char* const end = p + text.size();
  const auto at_digit = [&] { return p != end && *p >= '0' && *p <= '9'; };
  const bool negative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+')) ++p;
  std::uint64_t mantissa = 0;  // wraps where there are too many digits
  const char* const whole = p;
  for (; at_digit(); ++p) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
  std::ptrdiff_t digits = p - whole;
  std::ptrdiff_t places = 0;
  if (p != end && *p == '.') {
    const char* const fraction = ++p;
    for (; at_digit(); ++p) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
    places = p - fraction;
    digits += places;
  }
  if (digits == 0 || digits > Number::kMaxDigits) return {};
  const auto magnitude = static_cast<std::int64_t>(mantissa);
  return {Number::decimal(negative ? -magnitude : magnitude, static_cast<int>(places)),
          static_cast<std::size_t>(p - text.data())};
}

}  // namespace plumbline

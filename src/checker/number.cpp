// Numbers: their two texts, their doubles and their order.

#include "number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace plumbline_checker {
namespace {

constexpr long kMaxExponent = 200;          // of `near`
constexpr std::size_t kDigitsOfAWord = 18;  // 10^18 < 2^63

bool all_digits(std::string_view text) {
  for (const char c : text) {
    if (c < '0' || c > '9') return false;
  }
  return !text.empty();
}

/// Requires: all_digits.
mpz_class integer(std::string_view digits) {
  if (digits.size() > kDigitsOfAWord) return mpz_class(std::string(digits), 10);
  unsigned long value = 0;
  for (const char c : digits) value = 10 * value + static_cast<unsigned long>(c - '0');
  return value;
}

double near_quotient(const mpz_class& n, const mpz_class& d) {
  long above = 0;
  long below = 0;
  const double numerator = leading_part(n, above);
  const double denominator = leading_part(d, below);
  if (numerator == 0) return 0;
  const long exponent = above - below;
  if (exponent > kMaxExponent || exponent < -kMaxExponent) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  // Three relative errors, of 2^-52, 2^-52 and 2^-53.
  return std::ldexp(numerator / denominator, static_cast<int>(exponent));
}

/// Takes a sign off the text; whether it was a minus.
bool take_sign(std::string_view& text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  return negative;
}

/// The exponent that a text denotes, none if it is none or beyond the limit.
std::optional<long> exponent_of(std::string_view text) {
  const bool negative = take_sign(text);
  if (!all_digits(text)) return std::nullopt;
  long value = 0;
  for (const char c : text) {
    value = 10 * value + (c - '0');
    if (value > static_cast<long>(kMaxInputDigits)) return std::nullopt;
  }
  return negative ? -value : value;
}

/// An integer with an optional sign.
std::optional<mpz_class> signed_integer(std::string_view text) {
  const bool negative = take_sign(text);
  if (!all_digits(text) || text.size() > kMaxInputDigits) return std::nullopt;
  const mpz_class size = integer(text);
  return negative ? mpz_class(-size) : size;
}

/// Requires: exponent >= 0.
mpz_class power_of_ten(long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
  return power;
}

/// Requires: d > 0.
Number quotient(mpz_class n, mpz_class d) {
  const mpz_class divisor = gcd(n, d);
  if (divisor == 1) return {std::move(n), std::move(d)};
  return {n / divisor, d / divisor};
}

}  // namespace

Number::Number(mpz_class lowest_numerator, mpz_class lowest_denominator)
    : numerator(std::move(lowest_numerator)),
      denominator(std::move(lowest_denominator)),
      near(near_quotient(numerator, denominator)) {}

double leading_part(const mpz_class& z, long& exponent) {
  return mpz_get_d_2exp(&exponent, z.get_mpz_t());
}

std::optional<Number> input_number(std::string_view text) {
  if (const std::size_t slash = text.find('/'); slash != text.npos) {
    std::optional<mpz_class> numerator = signed_integer(text.substr(0, slash));
    std::optional<mpz_class> denominator = signed_integer(text.substr(slash + 1));
    if (!numerator || !denominator || *denominator <= 0) return std::nullopt;
    return quotient(*std::move(numerator), *std::move(denominator));
  }
  const bool negative = take_sign(text);
  const std::size_t end_of_mantissa = std::min(text.find_first_of("eE"), text.size());
  long exponent = 0;
  if (end_of_mantissa < text.size()) {
    const std::optional<long> written = exponent_of(text.substr(end_of_mantissa + 1));
    if (!written) return std::nullopt;
    exponent = *written;
  }
  const std::string_view mantissa = text.substr(0, end_of_mantissa);
  const std::size_t dot = std::min(mantissa.find('.'), mantissa.size());
  std::string digits(mantissa.substr(0, dot));
  if (dot < mantissa.size()) {
    digits += mantissa.substr(dot + 1);
    exponent -= static_cast<long>(mantissa.size() - dot - 1);
  }
  if (!all_digits(digits) || digits.size() > kMaxInputDigits) return std::nullopt;
  mpz_class value = integer(digits);
  if (negative) value = -value;
  if (exponent < 0) return quotient(std::move(value), power_of_ten(-exponent));
  if (exponent > 0) value *= power_of_ten(exponent);
  return Number(std::move(value), 1);
}

std::optional<Number> canonical_number(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::string_view above = text.substr(0, slash);
  const auto is_canonical = [](std::string_view digits) {
    return all_digits(digits) && (digits[0] != '0' || digits.size() == 1);
  };
  if (!is_canonical(above) || (negative && above == "0")) return std::nullopt;
  mpz_class numerator = integer(above);
  mpz_class denominator = 1;
  if (slash < text.size()) {
    const std::string_view below = text.substr(slash + 1);
    if (!is_canonical(below) || below == "0" || below == "1") return std::nullopt;
    denominator = integer(below);
    if (gcd(numerator, denominator) != 1) return std::nullopt;
  }
  if (negative) numerator = -numerator;
  return Number(std::move(numerator), std::move(denominator));
}

int compare(const Number& a, const Number& b) {
  // The errors of both, and of the difference, are below a half of this.
  const double bound = 0x1p-48 * (std::abs(a.near) + std::abs(b.near));
  const double difference = a.near - b.near;
  if (difference > bound) return 1;
  if (difference < -bound) return -1;
  if (a == b) return 0;
  return sgn(mpz_class(a.numerator * b.denominator - b.numerator * a.denominator));
}

int compare(const Point& a, const Point& b) {
  const int by_x = compare(a.x, b.x);
  return by_x != 0 ? by_x : compare(a.y, b.y);
}

std::string text_of(const Point& point) {
  constexpr std::size_t kShown = 100;
  const auto shown = [](const Number& number) {
    std::string text = mpq_class(number.numerator, number.denominator).get_str();
    if (text.size() > kShown) text = text.substr(0, kShown) + "...";
    return text;
  };
  return "(" + shown(point.x) + ", " + shown(point.y) + ")";
}

}  // namespace plumbline_checker

// Decimal text <-> rational. The limits are checked while scanning, before any big number is made.

#include <algorithm>
#include <numeric>
#include <optional>

#include "number/wide.hpp"
#include "plumbline/error.hpp"
#include "plumbline/number.hpp"

namespace plumbline {
namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The parts of a decimal text.
struct Scanned {
  bool negative = false;
  std::string digits;  ///< of the mantissa, without the point
  long exponent = 0;   ///< of ten, after moving the point behind the last digit
};

[[noreturn]] void not_a_number(std::string_view text) {
  throw Error(ErrorCode::BadInput, "not a number", {}, std::string(text));
}

void check_digit_count(std::size_t count, std::string_view text) {
  if (count > kMaxDecimalDigits) {
    throw Error(ErrorCode::Limit,
                "number of more than " + std::to_string(kMaxDecimalDigits) + " digits", {},
                std::string(text.substr(0, 100)));
  }
}

std::string_view leading_digits(std::string_view text) {
  return text.substr(0, std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
}

bool take_sign(std::string_view& rest) {
  if (rest.empty() || (rest[0] != '+' && rest[0] != '-')) return false;
  const bool negative = rest[0] == '-';
  rest.remove_prefix(1);
  return negative;
}

/// The exponent behind the letter e; `rest` is all that is left of `text`.
long scan_exponent(std::string_view rest, std::string_view text) {
  const bool negative = take_sign(rest);
  if (rest.empty() || leading_digits(rest).size() != rest.size()) not_a_number(text);
  long exponent = 0;
  for (const char digit : rest) {
    exponent = exponent * 10 + (digit - '0');
    if (exponent > kMaxDecimalExponent) {
      throw Error(ErrorCode::Limit,
                  "decimal exponent beyond " + std::to_string(kMaxDecimalExponent), {},
                  std::string(text));
    }
  }
  return negative ? -exponent : exponent;
}

Scanned scan(std::string_view text) {
  Scanned scanned;
  std::string_view rest = text;
  scanned.negative = take_sign(rest);
  const std::string_view whole = leading_digits(rest);
  rest.remove_prefix(whole.size());
  std::string_view fraction;
  if (!rest.empty() && rest[0] == '.') {
    rest.remove_prefix(1);
    fraction = leading_digits(rest);
    rest.remove_prefix(fraction.size());
  }
  if (whole.empty() && fraction.empty()) not_a_number(text);
  check_digit_count(whole.size() + fraction.size(), text);
  if (!rest.empty()) {
    if (rest[0] != 'e' && rest[0] != 'E') not_a_number(text);
    scanned.exponent = scan_exponent(rest.substr(1), text);
  }
  scanned.exponent -= static_cast<long>(fraction.size());
  scanned.digits.reserve(whole.size() + fraction.size());
  scanned.digits.append(whole).append(fraction);
  return scanned;
}

mpz_class power_of_ten(unsigned long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, exponent);
  return power;
}

/// All decimals of up to this many digits and places fit into 64 bits.
constexpr std::size_t kMachineDigits = 18;

bool fits_machine(const Scanned& s) {
  return s.digits.size() <= kMachineDigits && s.exponent <= 0 &&
         -s.exponent <= static_cast<long>(kMachineDigits);
}

/// Requires: fits_machine(s). The common case, without big-number arithmetic.
Rational from_machine_integers(const Scanned& s) {
  unsigned long numerator = 0;
  for (const char digit : s.digits) {
    numerator = numerator * 10 + static_cast<unsigned long>(digit - '0');
  }
  unsigned long denominator = 1;
  for (long i = s.exponent; i < 0; ++i) denominator *= 10;
  const unsigned long divisor = std::gcd(numerator, denominator);
  Rational value;
  mpz_set_ui(value.get_num_mpz_t(), numerator / divisor);
  mpz_set_ui(value.get_den_mpz_t(), denominator / divisor);
  return value;
}

Rational from_big_integers(const Scanned& s) {
  Rational value(mpz_class(s.digits, 10));
  if (s.exponent >= 0) {
    value.get_num() *= power_of_ten(static_cast<unsigned long>(s.exponent));
  } else {
    value.get_den() = power_of_ten(static_cast<unsigned long>(-s.exponent));
    value.canonicalize();
  }
  return value;
}

Rational parse_fraction(std::string_view text, std::size_t slash) {
  std::string_view numerator = text.substr(0, slash);
  const std::string_view denominator = text.substr(slash + 1);
  const bool negative = take_sign(numerator);
  for (const std::string_view part : {numerator, denominator}) {
    if (part.empty() || leading_digits(part).size() != part.size()) not_a_number(text);
    check_digit_count(part.size(), text);
  }
  Rational value(mpz_class(std::string(numerator), 10), mpz_class(std::string(denominator), 10));
  if (value.get_den() == 0) {
    throw Error(ErrorCode::BadInput, "denominator is 0", {}, std::string(text));
  }
  value.canonicalize();
  return negative ? Rational(-value) : value;
}

/// The longest decimal that `exact_text` writes.
constexpr std::size_t kShownDigits = 40;

/// The least k such that denominator divides 10^k, if there is one.
std::optional<std::size_t> decimal_places(const mpz_class& denominator) {
  const mpz_class five = 5;
  mpz_class rest;
  const std::size_t twos = mpz_scan1(denominator.get_mpz_t(), 0);
  const std::size_t fives = mpz_remove(rest.get_mpz_t(), denominator.get_mpz_t(), five.get_mpz_t());
  mpz_tdiv_q_2exp(rest.get_mpz_t(), rest.get_mpz_t(), twos);
  if (rest != 1) return {};
  return std::max(twos, fives);
}

std::string decimal_text(const Rational& value, std::size_t places) {
  const mpz_class scaled = abs(value.get_num()) * power_of_ten(places) / value.get_den();
  std::string digits = scaled.get_str();
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - places, ".");
  return (sgn(value) < 0 ? "-" : "") + digits;
}

}  // namespace

Rational parse_decimal(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string_view::npos) return parse_fraction(text, slash);
  const Scanned scanned = scan(text);
  Rational value =
      fits_machine(scanned) ? from_machine_integers(scanned) : from_big_integers(scanned);
  if (scanned.negative) mpq_neg(value.get_mpq_t(), value.get_mpq_t());
  return value;
}

std::string exact_text(const Rational& value) {
  std::string short_text;
  const auto fraction = wide::fraction(value);
  if (fraction && wide::append_exact(short_text, *fraction)) return short_text;
  if (value.get_den() == 1) return value.get_num().get_str();
  const std::optional<std::size_t> places = decimal_places(value.get_den());
  if (!places || *places > kShownDigits) return value.get_str();
  std::string text = decimal_text(value, *places);
  const std::size_t punctuation = sgn(value) < 0 ? 2 : 1;  // sign and point
  return text.size() > kShownDigits + punctuation ? value.get_str() : text;
}

std::string decimal_text(const Rational& value) {
  const std::optional<std::size_t> places = decimal_places(value.get_den());
  if (!places) throw Error(ErrorCode::BadInput, "not a decimal", {}, value.get_str());
  return decimal_text(value, *places);
}

}  // namespace plumbline

// The type Number against Rational.

#include <catch2/catch.hpp>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include "plumbline/error.hpp"
#include "plumbline/number.hpp"

using plumbline::nearest_double;
using plumbline::Number;
using plumbline::parse_decimal;
using plumbline::parse_number;
using plumbline::Rational;

namespace {

constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();

static_assert(sizeof(Number) == 16);
static_assert(std::is_nothrow_move_constructible_v<Number>);
static_assert(std::is_nothrow_move_assignable_v<Number>);

/// How a Number is held: "mantissa/digits", or the rational.
std::string held(const Number& n) {
  if (!n.is_decimal()) return n.rational().get_str();
  return std::to_string(n.mantissa()) + "e-" + std::to_string(n.digits());
}

Rational power(unsigned long base, unsigned long exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), base, exponent);
  return Rational(result);
}

/// Numbers of all sizes around the limits of what is held in place.
Number random_number(std::mt19937_64& random) {
  const auto digits = static_cast<int>(random() % (Number::kMaxDigits + 1));
  const auto mantissa = static_cast<std::int64_t>(random() >> random() % 64);
  const auto sign = random() % 2 == 0 ? 1 : -1;
  switch (random() % 8) {
    case 0:
      return Number::decimal(sign * (kMax - static_cast<std::int64_t>(random() % 3)), digits);
    case 1:
      return Rational(Rational(mantissa) * mantissa / power(10, random() % 30));
    case 2:
      return Rational(Rational(mantissa) / static_cast<long>(1 + random() % 100));
    case 3: {
      const Rational small = static_cast<long>(random() % 100);
      return Rational(small / power(random() % 2 == 0 ? 2 : 5, random() % 30));
    }
    case 4:
      return Number();
    default:
      return Number::decimal(mantissa, digits);
  }
}

std::string outcome(const std::string& text, auto parse) {
  try {
    return held(Number(parse(text)));
  } catch (const plumbline::Error& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE(
    "a decimal of few digits is held in place, with the fewest digits; others are rationals") {
  const auto [text, expected] = GENERATE(table<std::string, std::string>({
      {"0", "0e-0"},
      {"-0", "0e-0"},
      {"-0.000", "0e-0"},
      {"0e-10000", "0e-0"},
      {"5.", "5e-0"},
      {"-.50", "-5e-1"},
      {"+00012.50", "125e-1"},
      {"1200", "1200e-0"},
      {"1.2e3", "1200e-0"},
      {"12e-1", "12e-1"},
      {"1/8", "125e-3"},
      {"-7/2000", "-35e-4"},
      {"6/3", "2e-0"},
      {"1/3", "1/3"},
      {"999999999999999999", "999999999999999999e-0"},
      {"1000000000000000000", "1000000000000000000e-0"},
      {"9223372036854775807", "9223372036854775807e-0"},
      {"-9223372036854775807", "-9223372036854775807e-0"},
      {"9223372036854775808", "9223372036854775808"},
      {"-9223372036854775808", "-9223372036854775808"},
      {"-922337203685477580.8", "-4611686018427387904/5"},
      {"-922337203685477580.80", "-4611686018427387904/5"},
      {"922337203685477580.70", "9223372036854775807e-1"},
      {"0.000000000000000001", "1e-18"},
      {"0.0000000000000000010", "1e-18"},
      {"9.223372036854775807", "9223372036854775807e-18"},
      {"0.0000000000000000001", "1/10000000000000000000"},
      {"9.2233720368547758070000000000000", "9223372036854775807e-18"},
      {"1/262144", "3814697265625e-18"},
      {"1/524288", "1/524288"},
      {"1/3814697265625", "262144e-18"},
      {"1/19073486328125", "1/19073486328125"},
  }));
  CAPTURE(text);
  CHECK(held(parse_number(text)) == expected);
  CHECK(held(parse_decimal(text)) == expected);
  CHECK(parse_number(text).rational() == parse_decimal(text));
}

TEST_CASE("a mantissa and digits are brought to the fewest digits") {
  CHECK(held(Number::decimal(1500, 2)) == "15e-0");
  CHECK(held(Number::decimal(-1500, 4)) == "-15e-2");
  CHECK(held(Number::decimal(0, 18)) == "0e-0");
  CHECK(held(Number::decimal(std::numeric_limits<std::int64_t>::min(), 0)) ==
        "-9223372036854775808");
  CHECK(held(Number::decimal(std::numeric_limits<std::int64_t>::min(), 1)) ==
        "-4611686018427387904/5");
}

TEST_CASE("texts are read as by parse_decimal: the same numbers, the same errors") {
  std::mt19937_64 random(1202);
  const std::string alphabet = "00123456789999..--+eE/ x";
  std::size_t accepted = 0;
  for (int i = 0; i < 300'000; ++i) {
    std::string text;
    const std::size_t length = random() % (i % 3 == 0 ? 30 : 8);
    const std::size_t letters = i % 2 == 0 ? 17 : alphabet.size();  // half of them plain
    for (std::size_t k = 0; k < length; ++k) text += alphabet[random() % letters];
    CAPTURE(text);
    const std::string expected = outcome(text, parse_decimal);
    REQUIRE(outcome(text, parse_number) == expected);
    accepted += expected.find("not a number") == std::string::npos ? 1 : 0;
  }
  CHECK(accepted > 50'000);
}

TEST_CASE("sums, differences, products, order and rounding are those of the rationals") {
  std::mt19937_64 random(77);
  std::size_t decimals = 0;
  for (int i = 0; i < 100'000; ++i) {
    const Number a = random_number(random);
    const Number b = i % 10 == 0 ? a : random_number(random);
    const Rational p = a.rational(), q = b.rational();
    CAPTURE(held(a), held(b));
    REQUIRE(held(p) == held(a));
    REQUIRE(held(a + b) == held(Rational(p + q)));
    REQUIRE(held(a - b) == held(Rational(p - q)));
    REQUIRE(held(a * b) == held(Rational(p * q)));
    REQUIRE((a == b) == (p == q));
    REQUIRE((a < b) == (p < q));
    REQUIRE((a > b) == (p > q));
    REQUIRE(sgn(a) == sgn(p));
    REQUIRE(nearest_double(a) == nearest_double(p));
    decimals += (a * b).is_decimal() ? 1 : 0;
  }
  CHECK(decimals > 10'000);
  CHECK(decimals < 90'000);
}

TEST_CASE("copies are independent, and what was moved from can be used again") {
  for (const char* text : {"0.25", "1/3", "123456789012345678901234567890"}) {
    const Number original = parse_number(text);
    Number copy = original;
    Number moved = std::move(copy);
    CHECK(moved == original);
    copy = moved;
    CHECK(copy == original);
    copy = Number::decimal(7, 0);
    CHECK(moved == original);
    moved = *&moved;
    CHECK(moved == original);
    std::swap(copy, moved);
    CHECK(copy == original);
    CHECK(held(moved) == "7e-0");
    std::vector<Number> many;
    for (int i = 0; i < 100; ++i) many.push_back(original);
    CHECK(std::vector<Number>(many) == std::vector<Number>(100, original));
  }
}

TEST_CASE("a double becomes the Number of the rational that it is") {
  CHECK(held(plumbline::rational_from(-0.375)) == "-375e-3");
  CHECK(held(plumbline::rational_from(0.1)) == "3602879701896397/36028797018963968");
}

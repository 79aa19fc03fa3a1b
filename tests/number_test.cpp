#include "plumbline/number.hpp"

#include <mpfr.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "plumbline/error.hpp"

using plumbline::exact_text;
using plumbline::nearest_double;
using plumbline::parse_decimal;
using plumbline::Rational;
using plumbline::rational_from;
using plumbline::shortest_text;

namespace {

plumbline::ErrorCode code_of(const std::string& text) {
  try {
    parse_decimal(text);
  } catch (const plumbline::Error& error) {
    return error.code();
  }
  FAIL("accepted: " << text.substr(0, 60));
  return {};
}

/// What MPFR rounds the rational to, subnormals included.
double mpfr_nearest(const Rational& value) {
  const mpfr_exp_t emin = mpfr_get_emin();
  const mpfr_exp_t emax = mpfr_get_emax();
  mpfr_set_emin(-1073);  // the least subnormal is 0.5 * 2^-1073 in MPFR's terms
  mpfr_set_emax(1024);
  mpfr_t rounded;
  mpfr_init2(rounded, 53);
  const int direction = mpfr_set_q(rounded, value.get_mpq_t(), MPFR_RNDN);
  mpfr_subnormalize(rounded, direction, MPFR_RNDN);
  const double result = mpfr_get_d(rounded, MPFR_RNDN);
  mpfr_clear(rounded);
  mpfr_set_emin(emin);
  mpfr_set_emax(emax);
  return result;
}

Rational power_of_two(int exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 2, static_cast<unsigned long>(std::abs(exponent)));
  return exponent < 0 ? Rational(mpz_class(1), power) : Rational(power);
}

mpz_class random_bits(std::mt19937_64& random, unsigned bits) {
  mpz_class z = 1;
  for (unsigned i = 1; i < bits; ++i) z = 2 * z + static_cast<unsigned long>(random() & 1U);
  return z;
}

}  // namespace

TEST_CASE("a decimal is the rational number that it denotes") {
  const auto [text, numerator, denominator] =
      GENERATE(table<std::string, std::string, std::string>({
          {"0", "0", "1"},
          {"-0", "0", "1"},
          {"-0.0e5", "0", "1"},
          {"0e-10000", "0", "1"},
          {"0.1", "1", "10"},
          {"+7", "7", "1"},
          {"-.5", "-1", "2"},
          {"5.", "5", "1"},
          {"5.e1", "50", "1"},
          {"00012.50", "25", "2"},
          {"1e3", "1000", "1"},
          {"1E+3", "1000", "1"},
          {"125e-3", "1", "8"},
          {"1.5e-1", "3", "20"},
          {"9007199254740993", "9007199254740993", "1"},
          {"999999999999999999", "999999999999999999", "1"},
          {"0.000000000000000001", "1", "1000000000000000000"},
          {"1234567890123456789.5", "2469135780246913579", "2"},
          {"-0.00000000000000000005", "-1", "20000000000000000000"},
          {"10/4", "5", "2"},
          {"-6/3", "-2", "1"},
          {"+0/7", "0", "1"},
      }));
  CAPTURE(text);
  const Rational value = parse_decimal(text);
  CHECK(value.get_num().get_str() == numerator);
  CHECK(value.get_den().get_str() == denominator);
}

TEST_CASE("what is not a number is refused") {
  const std::string text = GENERATE(
      as<std::string>{}, "", "+", "-", ".", "-.", "e5", ".e5", "1e", "1e+", "1e1.5", "1.2.3", "--1",
      "+-1", " 1", "1 ", "1,5", "0x10", "nan", "inf", "1/0", "1/-2", "1/+2", "1/", "/2", "1/2/3",
      "1.5/2", "1e2/3", std::string("1\0", 2), "1_000", "\xd9\xa1");
  CAPTURE(text);
  CHECK(code_of(text) == plumbline::ErrorCode::BadInput);
}

TEST_CASE("numbers at the limits are read, numbers beyond are refused at once") {
  const std::string longest(plumbline::kMaxDecimalDigits, '9');
  CHECK(parse_decimal(longest).get_num().get_str() == longest);
  CHECK(parse_decimal("0." + longest.substr(1)) < 1);
  CHECK(parse_decimal("1/" + longest) > 0);
  CHECK(parse_decimal("1e10000").get_num().get_str().size() == 10'001);
  CHECK(parse_decimal("1e-0010000") > 0);
  const std::string text = GENERATE(
      as<std::string>{}, "1e10001", "1e-10001", "1e99999999999", "-1e-99999999999999999999999",
      "0e10001", std::string(10'001, '9'), "." + std::string(1'000'000, '0'),
      std::string(10'001, '1') + "/3", "3/" + std::string(10'001, '1'));
  CAPTURE(text.substr(0, 60));
  CHECK(code_of(text) == plumbline::ErrorCode::Limit);
}

TEST_CASE("a double is taken as the dyadic rational that it is") {
  CHECK(exact_text(rational_from(0.5)) == "0.5");
  CHECK(rational_from(0.1).get_str() == "3602879701896397/36028797018963968");
  CHECK(rational_from(-0.0) == 0);
  CHECK(rational_from(5e-324) == power_of_two(-1074));
  CHECK_THROWS_AS(rational_from(std::nan("")), plumbline::Error);
  CHECK_THROWS_AS(rational_from(-std::numeric_limits<double>::infinity()), plumbline::Error);
}

TEST_CASE("the nearest double is the one that MPFR rounds to, near and far from ties") {
  std::mt19937_64 random(20151101);
  for (int i = 0; i < 20'000; ++i) {
    const unsigned numerator_bits = 1 + static_cast<unsigned>(random() % 130);
    const unsigned denominator_bits = 1 + static_cast<unsigned>(random() % 130);
    Rational value(random_bits(random, numerator_bits), random_bits(random, denominator_bits));
    value.canonicalize();
    value *= power_of_two(static_cast<int>(random() % 2300) - 1150);
    if (random() % 2 == 0) value = -value;
    REQUIRE(nearest_double(value) == mpfr_nearest(value));
  }
}

TEST_CASE("half-way between two doubles the even one is taken, a hair beyond the nearer one") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 5'000; ++i) {
    // Exponents from the subnormals to beyond the largest double.
    const double low =
        std::ldexp(static_cast<double>(random() >> 11U), static_cast<int>(random() % 2098) - 1126);
    const double high = std::nextafter(low, std::numeric_limits<double>::infinity());
    if (!std::isfinite(high)) continue;
    const Rational tie = (rational_from(low) + rational_from(high)) / 2;
    const Rational hair = (rational_from(high) - rational_from(low)) * power_of_two(-200);
    std::uint64_t bits = 0;
    std::memcpy(&bits, &low, sizeof bits);
    REQUIRE(nearest_double(tie) == ((bits & 1U) == 0 ? low : high));
    REQUIRE(nearest_double(tie - hair) == low);
    REQUIRE(nearest_double(tie + hair) == high);
    REQUIRE(nearest_double(-tie - hair) == -high);
    REQUIRE(nearest_double(rational_from(low)) == low);
  }
}

TEST_CASE("rounding at the ends of the range is as in IEEE 754") {
  const double largest = std::numeric_limits<double>::max();
  const double infinity = std::numeric_limits<double>::infinity();
  const Rational overflow_tie = power_of_two(1024) - power_of_two(970);
  CHECK(nearest_double(overflow_tie) == infinity);
  CHECK(nearest_double(overflow_tie - 1) == largest);
  CHECK(nearest_double(-overflow_tie) == -infinity);
  CHECK(nearest_double(parse_decimal("1e10000")) == infinity);
  const Rational underflow_tie = power_of_two(-1075);
  CHECK(nearest_double(underflow_tie) == 0);
  CHECK_FALSE(std::signbit(nearest_double(-underflow_tie)));
  CHECK(nearest_double(underflow_tie * (1 + power_of_two(-90))) == 5e-324);
  CHECK(nearest_double(3 * underflow_tie) == 2 * 5e-324);
  CHECK(nearest_double(parse_decimal("-1e-10000")) == 0);
  CHECK(nearest_double(parse_decimal("2.2250738585072011e-308")) == 2.2250738585072011e-308);
}

TEST_CASE("the shortest text of a double reads back as the same double") {
  CHECK(shortest_text(0.1) == "0.1");
  CHECK(shortest_text(-0.0) == "0");
  CHECK(shortest_text(1e23) == "1e+23");
  CHECK(shortest_text(-2.5) == "-2.5");
  std::mt19937_64 random(3);
  for (int i = 0; i < 20'000; ++i) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    REQUIRE(nearest_double(parse_decimal(shortest_text(value))) == value);
  }
}

TEST_CASE("exact text is a decimal where there is a short one, a fraction elsewhere") {
  const auto [number, text] = GENERATE(table<std::string, std::string>({
      {"0", "0"},
      {"-1/8", "-0.125"},
      {"12.50", "12.5"},
      {"-3", "-3"},
      {"1/3", "1/3"},
      {"-7/15", "-7/15"},
      {"1e-39", "0.000000000000000000000000000000000000001"},
      {"1e-40", "1/10000000000000000000000000000000000000000"},
      {"1e45", "1000000000000000000000000000000000000000000000"},
      {"12345678901234567890.12345678901234567891", "12345678901234567890.12345678901234567891"},
      {"-12345678901234567890.123456789012345678912",
       "-192901232831790123283179012328317901233/15625000000000000000"},
  }));
  CHECK(exact_text(parse_decimal(number)) == text);
  CHECK(parse_decimal(text) == parse_decimal(number));
}

TEST_CASE("exact text reads back as the same rational") {
  std::mt19937_64 random(11);
  for (int i = 0; i < 5'000; ++i) {
    Rational value(random_bits(random, 1 + static_cast<unsigned>(random() % 90)));
    mpz_class denominator;
    mpz_ui_pow_ui(denominator.get_mpz_t(), i % 3 == 0 ? 2 : i % 3 == 1 ? 5 : 30, random() % 50);
    value /= denominator;
    REQUIRE(parse_decimal(exact_text(value)) == value);
  }
}

TEST_CASE("a square root is near at every size, and 0 only for 0") {
  using plumbline::nearest_sqrt;
  CHECK(nearest_sqrt(0) == 0);
  CHECK(nearest_sqrt(Rational(1, 4)) == 0.5);
  CHECK(nearest_sqrt(2) == std::sqrt(2.0));
  CHECK(nearest_sqrt(plumbline::parse_decimal("1e-640")) == 1e-320);
  CHECK(nearest_sqrt(plumbline::parse_decimal("4e600")) == Approx(2e300).epsilon(1e-15));
  CHECK(nearest_sqrt(plumbline::parse_decimal("1e-9000")) == 0);
}

TEST_CASE("a whole decimal expansion has all digits, and reads back") {
  using plumbline::decimal_text;
  CHECK(decimal_text(parse_decimal("-0.125")) == "-0.125");
  CHECK(decimal_text(parse_decimal("12")) == "12");
  CHECK(decimal_text(rational_from(0.1)) ==
        "0.1000000000000000055511151231257827021181583404541015625");
  CHECK(decimal_text(rational_from(5e-324)).size() == 1076);
  CHECK(parse_decimal(decimal_text(rational_from(-1.0 / 3))) == rational_from(-1.0 / 3));
  CHECK_THROWS_WITH(decimal_text(parse_decimal("1/3")), Catch::Contains("not a decimal"));
}

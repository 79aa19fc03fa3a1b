// Affine maps. Facts about rotations are checked in MPFR, at 400 bits.

#include "plumbline/structure/affine.hpp"

#include <mpfr.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "plumbline/error.hpp"

using plumbline::Affine;
using plumbline::ApproximateAffine;
using plumbline::exact_text;
using plumbline::Number;
using plumbline::parse_decimal;
using plumbline::Point;
using plumbline::Rational;
using plumbline::rotation;
using plumbline::rotation_in_radians;
using plumbline::rotation_in_space;
using plumbline::scaling;
using plumbline::shear;
using plumbline::translation;

namespace {

Point point(const std::string& text) {
  const auto blank = text.find(' ');
  return {parse_decimal(text.substr(0, blank)), parse_decimal(text.substr(blank + 1))};
}

Rational entry(const Affine& map, std::size_t row, std::size_t column) {
  return map(row, column).rational();
}

/// The linear part, row by row.
std::string rows(const Affine& map) {
  std::string text;
  for (std::size_t i = 0; i < map.dimension(); ++i) {
    for (std::size_t j = 0; j < map.dimension(); ++j) text += exact_text(entry(map, i, j)) + " ";
  }
  return text;
}

Affine transposed(const Affine& map) {
  Affine result = map;
  for (std::size_t i = 0; i < map.dimension(); ++i) {
    for (std::size_t j = 0; j < map.dimension(); ++j) result(i, j) = map(j, i);
  }
  return result;
}

std::string to_text(const Affine& m) {
  std::string text;
  for (const auto& [row, column] : {std::pair(0, 0), {1, 0}, {0, 1}, {1, 1}, {0, 2}, {1, 2}}) {
    text += exact_text(m(row, column).rational()) + " ";
  }
  return text;
}

/// |angle of (cosine, sine) - degrees|, in radians, computed by MPFR with 400 bits.
double angle_error(const Affine& map, const Rational& degrees) {
  mpfr_t c, s, angle;
  mpfr_inits2(400, c, s, angle, nullptr);
  mpfr_const_pi(angle, MPFR_RNDN);
  mpfr_mul_q(angle, angle, degrees.get_mpq_t(), MPFR_RNDN);
  mpfr_div_ui(angle, angle, 180, MPFR_RNDN);
  // The angle left after turning (cosine, sine) back by `angle`.
  mpfr_t cosine, sine;
  mpfr_inits2(400, cosine, sine, nullptr);
  mpfr_sin_cos(sine, cosine, angle, MPFR_RNDN);
  mpfr_mul_q(c, sine, entry(map, 1, 0).get_mpq_t(), MPFR_RNDN);
  mpfr_mul_q(angle, cosine, entry(map, 0, 0).get_mpq_t(), MPFR_RNDN);
  mpfr_add(c, c, angle, MPFR_RNDN);
  mpfr_mul_q(s, cosine, entry(map, 1, 0).get_mpq_t(), MPFR_RNDN);
  mpfr_mul_q(angle, sine, entry(map, 0, 0).get_mpq_t(), MPFR_RNDN);
  mpfr_sub(s, s, angle, MPFR_RNDN);
  mpfr_atan2(angle, s, c, MPFR_RNDN);
  const double error = std::fabs(mpfr_get_d(angle, MPFR_RNDA));
  mpfr_clears(c, s, angle, cosine, sine, nullptr);
  return error;
}

}  // namespace

TEST_CASE("an affine map has the order of SVG's matrix") {
  const Affine map{2, 3, 5, 7, 11, 13};
  CHECK(to_text(apply(map, point("1 0"))) == "13 16");
  CHECK(to_text(apply(map, point("0 1"))) == "16 20");
  CHECK(to_text(apply(translation(1, 2), point("0.1 0.2"))) == "1.1 2.2");
  CHECK(to_text(apply(scaling(-1, 3), point("0.1 0.2"))) == "-0.1 0.6");
}

TEST_CASE("composition applies the inner map first") {
  const Affine outer{2, 3, 5, 7, 11, 13};
  const Affine inner{-1, 4, Rational(1, 3), 0, 6, -2};
  for (const Point& p : {point("0 0"), point("1 0"), point("0 1"), point("0.7 -9")}) {
    CHECK(to_text(apply(compose(outer, inner), p)) == to_text(apply(outer, apply(inner, p))));
  }
  CHECK(compose(outer, Affine{}) == outer);
  CHECK(compose(Affine{}, outer) == outer);
}

TEST_CASE("rotation by a multiple of 90 degrees is exact") {
  const auto [degrees, entries] = GENERATE(table<std::string, std::string>({
      {"0", "1 0 0 1 0 0 "},
      {"90", "0 1 -1 0 0 0 "},
      {"180", "-1 0 0 -1 0 0 "},
      {"270", "0 -1 1 0 0 0 "},
      {"-90", "0 -1 1 0 0 0 "},
      {"360", "1 0 0 1 0 0 "},
      {"-630", "0 1 -1 0 0 0 "},
      {"9e50", "1 0 0 1 0 0 "},
  }));
  const ApproximateAffine turned = rotation(parse_decimal(degrees));
  CHECK(to_text(turned.map) == entries);
  CHECK(turned.bound == 0);
}

TEST_CASE("rotation by another angle is an exact isometry within the bound") {
  const double bound = GENERATE(1e-3, 1e-9, plumbline::kAngleBound, 1e-30, 1e-100);
  std::mt19937_64 random(30);
  for (int i = 0; i < 300; ++i) {
    Rational degrees(static_cast<long>(random() % 1'000'000) - 500'000, 997);
    degrees.canonicalize();
    const auto [map, deviation] = rotation(degrees, bound);
    const Rational cosine = entry(map, 0, 0);
    const Rational sine = entry(map, 1, 0);
    REQUIRE(cosine * cosine + sine * sine == 1);
    REQUIRE(map == Affine{cosine, sine, -sine, cosine, 0, 0});
    REQUIRE(deviation == plumbline::rational_from(bound));
    REQUIRE(angle_error(map, degrees) <= bound);
  }
}

TEST_CASE("rotation takes the simplest rational half-angle tangent within the bound") {
  // tan 15 degrees = [0; 3, 1, 2, 1, 2, ...]: 4/15 is off by 0.00128, 11/41 by 0.00035.
  CHECK(to_text(rotation(30, 1e-3).map) == "780/901 451/901 -451/901 780/901 0 0 ");
  CHECK(to_text(rotation(120, 1e-3).map) == "-451/901 780/901 -780/901 -451/901 0 0 ");
  CHECK(to_text(rotation(-30, 1e-3).map) == "780/901 -451/901 451/901 780/901 0 0 ");
}

TEST_CASE("rotation by a tiny, an odd-sized or a huge angle keeps its bound") {
  const std::string degrees = GENERATE(as<std::string>{}, "1e-10000", "-1e-14", "45", "-45", "135",
                                       "44.99999999999999999", "1e10000", "1/7");
  const auto [map, deviation] = rotation(parse_decimal(degrees));
  const Rational cosine = entry(map, 0, 0);
  const Rational sine = entry(map, 1, 0);
  CHECK(cosine * cosine + sine * sine == 1);
  Rational reduced = parse_decimal(degrees) / 360;
  mpz_class turns;
  mpz_fdiv_q(turns.get_mpz_t(), reduced.get_num_mpz_t(), reduced.get_den_mpz_t());
  CHECK(angle_error(map, (reduced - turns) * 360) <= plumbline::kAngleBound);
}

TEST_CASE("skew is exact at multiples of 45 degrees and within its bound elsewhere") {
  CHECK(to_text(plumbline::skew_x(45, 1e-3).map) == "1 0 1 1 0 0 ");
  CHECK(to_text(plumbline::skew_y(-45).map) == "1 -1 0 1 0 0 ");
  CHECK(to_text(plumbline::skew_x(135).map) == "1 0 -1 1 0 0 ");
  CHECK(to_text(plumbline::skew_x(-360).map) == "1 0 0 1 0 0 ");
  CHECK(plumbline::skew_x(225).bound == 0);
  // sqrt 3 = [1; 1, 2, 1, 2, ...]: 26/15 is off by 0.0013, 71/41 by 0.0003; its inverse 0.577.
  CHECK(to_text(plumbline::skew_x(60, 1e-3).map) == "1 0 71/41 1 0 0 ");
  CHECK(to_text(plumbline::skew_y(-120, 1e-3).map) == "1 71/41 0 1 0 0 ");
  CHECK(plumbline::skew_x(60, 1e-3).bound == plumbline::rational_from(1e-3));
  for (const char* angle : {"89.999999", "1e-7", "12.5", "-77.7"}) {
    const Rational degrees = parse_decimal(angle);
    const Rational factor = entry(plumbline::skew_x(degrees, 1e-12).map, 0, 1);
    mpfr_t tangent;
    mpfr_init2(tangent, 300);
    mpfr_const_pi(tangent, MPFR_RNDN);
    mpfr_mul_q(tangent, tangent, degrees.get_mpq_t(), MPFR_RNDN);
    mpfr_div_ui(tangent, tangent, 180, MPFR_RNDN);
    mpfr_tan(tangent, tangent, MPFR_RNDN);
    mpfr_sub_q(tangent, tangent, factor.get_mpq_t(), MPFR_RNDN);
    CHECK(std::fabs(mpfr_get_d(tangent, MPFR_RNDA)) <= 1e-12);
    mpfr_clear(tangent);
  }
}

TEST_CASE("skews by right angles and unusable bounds are refused") {
  CHECK_THROWS_AS(plumbline::skew_x(90), plumbline::Error);
  CHECK_THROWS_AS(plumbline::skew_y(-270), plumbline::Error);
  CHECK_THROWS_AS(rotation(30, 0), plumbline::Error);
  CHECK_THROWS_AS(rotation(30, -1e-9), plumbline::Error);
  CHECK_THROWS_AS(rotation(30, std::nan("")), plumbline::Error);
}

TEST_CASE("a decimal angle in radians within the bound of a quarter turn gives it") {
  const auto [radians, linear] = GENERATE(table<std::string, std::string>({
      {"1.5707963267948966", "0 -1 1 0 "},
      {"-1.5707963267948966", "0 1 -1 0 "},
      {"3.141592653589793", "-1 0 0 -1 "},
      {"6.283185307179586", "1 0 0 1 "},
      {"0", "1 0 0 1 "},
  }));
  CHECK(rows(rotation_in_radians(parse_decimal(radians)).map) == linear);
  CHECK(rotation_in_radians(0).bound == 0);
}

TEST_CASE("a rotation in radians is an exact isometry within the bound") {
  const double bound = GENERATE(1e-3, plumbline::kAngleBound, 1e-40);
  std::mt19937_64 random(31);
  for (int i = 0; i < 200; ++i) {
    Rational radians(static_cast<long>(random() % 20'000'000) - 10'000'000, 999'983);
    radians.canonicalize();
    const auto [map, deviation] = rotation_in_radians(radians, bound);
    const Rational cosine = entry(map, 0, 0);
    const Rational sine = entry(map, 1, 0);
    REQUIRE(cosine * cosine + sine * sine == 1);
    REQUIRE(deviation == plumbline::rational_from(bound));
    mpfr_t angle, c, s;
    mpfr_inits2(400, angle, c, s, nullptr);
    mpfr_set_q(angle, radians.get_mpq_t(), MPFR_RNDN);
    mpfr_sin_cos(s, c, angle, MPFR_RNDN);
    // sin of the angle between: sine c - cosine s.
    mpfr_mul_q(c, c, sine.get_mpq_t(), MPFR_RNDN);
    mpfr_mul_q(s, s, cosine.get_mpq_t(), MPFR_RNDN);
    mpfr_sub(c, c, s, MPFR_RNDN);
    mpfr_asin(c, c, MPFR_RNDN);
    REQUIRE(std::fabs(mpfr_get_d(c, MPFR_RNDA)) <= bound);
    mpfr_clears(angle, c, s, nullptr);
  }
}

TEST_CASE("rotations about the coordinate axes turn counter-clockwise, by negative angles back") {
  const Rational quarter = parse_decimal("1.5707963267948966");
  const auto turn = [](const Rational& x, const Rational& y, const Rational& z) {
    return rows(rotation_in_space({x, y, z}).map);
  };
  CHECK(turn(quarter, 0, 0) == "1 0 0 0 0 -1 0 1 0 ");
  CHECK(turn(0, quarter, 0) == "0 0 1 0 1 0 -1 0 0 ");
  CHECK(turn(0, 0, quarter) == "0 -1 0 1 0 0 0 0 1 ");
  // The published module loses these signs (L1 of the catalogue of its divergences).
  CHECK(turn(-quarter, 0, 0) == "1 0 0 0 0 1 0 -1 0 ");
  CHECK(turn(0, -quarter, 0) == "0 0 -1 0 1 0 1 0 0 ");
  CHECK(turn(0, 0, -quarter) == "0 1 0 -1 0 0 0 0 1 ");
  CHECK(turn(0, 0, 0) == "1 0 0 0 1 0 0 0 1 ");
  CHECK(rotation_in_space({0, 0, 0}).bound == 0);
}

TEST_CASE("a third of a turn about the diagonal permutes the axes") {
  // 2 pi / (3 sqrt 3) along each axis.
  const Rational x = parse_decimal("1.2091995761561452");
  CHECK(rows(rotation_in_space({x, x, x}).map) == "0 0 1 1 0 0 0 1 0 ");
}

TEST_CASE("a rotation of space fixes its axis, is orthogonal, and close to Rodrigues' formula") {
  std::mt19937_64 random(32);
  const auto number = [&] {
    Rational value(static_cast<long>(random() % 8001) - 4000, 1 + random() % 2000);
    value.canonicalize();
    return value;
  };
  for (int i = 0; i < 200; ++i) {
    const std::array<Rational, 3> v{number(), number(), number()};
    const Affine map = rotation_in_space(v).map;
    REQUIRE(compose(map, transposed(map)) == Affine(3));
    const std::array<Number, 3> axis{v[0], v[1], v[2]};
    std::array<Number, 3> image;
    apply(map, axis, image);
    REQUIRE(image == axis);
    const double x = v[0].get_d(), y = v[1].get_d(), z = v[2].get_d();
    const double angle = std::sqrt(x * x + y * y + z * z);
    if (angle == 0) continue;
    const std::array<double, 3> u{x / angle, y / angle, z / angle};
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double cross = r == c ? 0 : (c == (r + 1) % 3 ? -1 : 1) * u[3 - r - c];
        const double rodrigues = (r == c ? std::cos(angle) : 0) + std::sin(angle) * cross +
                                 (1 - std::cos(angle)) * u[r] * u[c];
        REQUIRE(nearest_double(map(r, c)) == Approx(rodrigues).margin(1e-11));
      }
    }
  }
}

TEST_CASE("a tiny or a huge rotation of space is an isometry") {
  const std::string size = GENERATE(as<std::string>{}, "1e-1000", "1e1000", "123456789.25");
  const Affine map = rotation_in_space({parse_decimal(size), 1, -2}).map;
  CHECK(compose(map, transposed(map)) == Affine(3));
}

TEST_CASE("the inverse undoes a map of any dimension") {
  Affine map = compose(shear(4, 0, 2, Rational(1, 3)), scaling({2, -1, 5, Rational(1, 7)}));
  map = compose(map, translation({1, 2, 3, 4}));
  map(1, 3) = Number(Rational(2));
  CHECK(compose(map, inverse(map)) == Affine(4));
  CHECK(compose(inverse(map), map) == Affine(4));
  CHECK(inverse(Affine{0, 1, 1, 0, 5, 7}) == Affine{0, 1, 1, 0, -7, -5});
  CHECK_THROWS_AS(inverse(scaling(0, 1)), plumbline::Error);
}

TEST_CASE("an embedded map does the same in the old dimensions and nothing in the new") {
  const Affine map{2, 3, 5, 7, 11, 13};
  const Affine space = embed(map, 1);
  CHECK(rows(space) == "2 5 0 3 7 0 0 0 1 ");
  CHECK(exact_text(entry(space, 0, 3)) == "11");
  CHECK(entry(space, 2, 3) == 0);
  CHECK(embed(space, -1) == map);
  CHECK(embed(embed(map, 5), -5) == map);
  CHECK_THROWS_AS(embed(map, -2), plumbline::Error);
  CHECK_THROWS_AS(embed(shear(3, 0, 2, 1), -1), plumbline::Error);
  CHECK(rows(embed(shear(3, 2, 0, 1), -1)) == "1 0 0 1 ");
}

TEST_CASE("maps of different dimensions are not composed") {
  CHECK_THROWS_AS(compose(Affine(2), Affine(3)), plumbline::Error);
  CHECK_THROWS_AS(Affine(0), plumbline::Error);
}

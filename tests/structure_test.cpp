#include "plumbline/structure.hpp"

#include <mpfr.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "plumbline/error.hpp"
#include "support/listing.hpp"

using plumbline::Affine;
using plumbline::ApproximateAffine;
using plumbline::evaluate;
using plumbline::Model;
using plumbline::parse_decimal;
using plumbline::Point;
using plumbline::Rational;
using plumbline::rotation;
using plumbline::scaling;
using plumbline::Struct;
using plumbline::StructId;
using plumbline::Structure;
using plumbline::translation;

namespace {

Point point(const std::string& text) {
  const auto blank = text.find(' ');
  return {parse_decimal(text.substr(0, blank)), parse_decimal(text.substr(blank + 1))};
}

/// The segment "ax ay, bx by" as a model.
Model model(const std::string& text, const std::string& id = "") {
  const auto comma = text.find(", ");
  plumbline::Source source;
  source.id = id;
  return {source, {{point(text.substr(0, comma)), point(text.substr(comma + 2))}}, {}};
}

Structure structure_of(std::vector<Struct> structs) {
  Structure structure;
  structure.structs = std::move(structs);
  structure.root = StructId(0);
  return structure;
}

std::string to_text(const Affine& m) {
  std::string text;
  for (const auto* x : {&m.a, &m.b, &m.c, &m.d, &m.e, &m.f})
    text += plumbline::exact_text(*x) + " ";
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
  mpfr_mul_q(c, sine, map.b.get_mpq_t(), MPFR_RNDN);
  mpfr_mul_q(angle, cosine, map.a.get_mpq_t(), MPFR_RNDN);
  mpfr_add(c, c, angle, MPFR_RNDN);
  mpfr_mul_q(s, cosine, map.b.get_mpq_t(), MPFR_RNDN);
  mpfr_mul_q(angle, sine, map.a.get_mpq_t(), MPFR_RNDN);
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
    REQUIRE(map.a * map.a + map.b * map.b == 1);
    REQUIRE(map == Affine{map.a, map.b, -map.b, map.a, 0, 0});
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
  CHECK(map.a * map.a + map.b * map.b == 1);
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
    const Rational factor = plumbline::skew_x(degrees, 1e-12).map.c;
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

TEST_CASE("a map applies to all that follows it in the same body, the last one first") {
  CHECK(listing(structure_of({{"root",
                               "",
                               {model("0 0, 1 0"), translation(10, 0), model("0 0, 1 0"),
                                scaling(2, 2), model("0 0, 1 0"), StructId(1)}},
                              {"inner", "", {translation(0, 1), model("0 0, 1 0", "deep")}}})) ==
        "0 0, 1 0 | \n"
        "10 0, 11 0 | \n"
        "10 0, 12 0 | \n"
        "10 2, 12 2 | #deep (inner)\n");
}

TEST_CASE("a map in a sub-structure ends with it") {
  CHECK(listing(structure_of({{"", "", {StructId(1), model("0 0, 1 0")}},
                              {"", "", {translation(5, 5), model("0 0, 1 0")}}})) ==
        "5 5, 6 5 | \n"
        "0 0, 1 0 | \n");
}

TEST_CASE("a shared structure appears once for each reference, under its path of names") {
  CHECK(listing(structure_of({{"root", "", {StructId(1), translation(0, 3), StructId(1)}},
                              {"flat", "", {StructId(2), StructId(3)}},
                              {"", "", {model("0 0, 1 0", "a")}},
                              {"room", "", {model("0 1, 1 1", "b")}}})) ==
        "0 0, 1 0 | #a (flat)\n"
        "0 1, 1 1 | #b (flat/room)\n"
        "0 3, 1 3 | #a (flat)\n"
        "0 4, 1 4 | #b (flat/room)\n");
}

TEST_CASE("a segment that a map shrinks to nothing is rejected with its source") {
  CHECK(listing(structure_of({{"", "", {scaling(0, 1), StructId(1)}},
                              {"g", "", {model("1 2, 3 2", "w"), model("1 2, 3 4", "v")}}})) ==
        "0 2, 0 4 | #v (g)\n"
        "rejected:\n"
        "#w (g): zero-length segment: 0 2, 0 2\n");
}

TEST_CASE("what the reader refused and replaced is carried over") {
  Structure structure = structure_of({{}});
  structure.files = {"a.svg"};
  structure.rejected = {
      {{0, 2, 3, "text", "", ""}, "element text is not understood yet", "<text>"}};
  structure.ledger = {{{0, 2, 3, "g", "", ""}, "rotate(30)", "1e-15 rad"}};
  const auto set = evaluate(structure);
  CHECK(set.files == structure.files);
  CHECK(set.rejected == structure.rejected);
  CHECK(set.ledger == structure.ledger);
}

TEST_CASE("decimals are mapped as rationals are, where they outgrow machine integers too") {
  std::mt19937_64 random(12);
  const auto number = [&] {
    const auto mantissa = static_cast<std::int64_t>(random() >> (1 + random() % 63));
    const int digits = static_cast<int>(random() % 19);
    const Rational value = plumbline::Number::decimal(mantissa, digits).rational();
    return random() % 20 == 0 ? Rational(value / 3) : Rational(random() % 2 == 0 ? value : -value);
  };
  const auto entry = [&] { return random() % 3 == 0 ? Rational(0) : number(); };
  for (int i = 0; i < 5000; ++i) {
    const Affine map{number(), entry(), entry(), number(), entry(), entry()};
    const plumbline::Segment segment{{number(), number()}, {number(), number()}};
    const auto set = evaluate(structure_of({{"", "", {map, Model{{}, {segment}, {}}}}}));
    if (set.segments.empty()) continue;  // mapped to one point
    REQUIRE(set.segments[0].a == apply(map, segment.a));
    REQUIRE(set.segments[0].b == apply(map, segment.b));
  }
}

TEST_CASE("the rows of a model are elements of their own") {
  Model table = model("0 0, 1 0", "t");
  table.segments.push_back({point("5 5"), point("5 5")});
  table.segments.push_back({point("0 0"), point("0 1")});
  table.source.element = "row";
  table.rows = {{3, 1}, {4, 2}, {6, 1}};
  CHECK(listing(structure_of({{"", "", {table}}})) ==
        "0 0, 1 0 | line 3:1 row #t\n"
        "0 0, 0 1 | line 6:1 row #t\n"
        "rejected:\n"
        "line 4:2 row #t: zero-length segment: 5 5, 5 5\n");
  table.rows.pop_back();
  CHECK_THROWS_AS(evaluate(structure_of({{"", "", {table}}})), plumbline::Error);
}

TEST_CASE("a cycle of references is refused, its names given") {
  const auto cyclic = structure_of({{"root", "", {StructId(1)}},
                                    {"flat", "", {StructId(2)}},
                                    {"", "", {StructId(3)}},
                                    {"room", "", {StructId(1)}}});
  try {
    evaluate(cyclic);
    FAIL("no error");
  } catch (const plumbline::Error& error) {
    CHECK(std::string(error.what()) == "cycle of references: \"flat/Struct 2/room/flat\"");
    CHECK(error.code() == plumbline::ErrorCode::BadInput);
  }
}

TEST_CASE("a reference to no Struct is refused") {
  CHECK_THROWS_AS(evaluate(structure_of({{"", "", {StructId(1)}}})), plumbline::Error);
  CHECK_THROWS_AS(evaluate(Structure{}), plumbline::Error);
}

TEST_CASE("a million nested structures are evaluated and freed") {
  constexpr std::size_t kDepth = 1'000'000;
  Structure structure;
  structure.structs.resize(kDepth);
  for (std::size_t i = 0; i + 1 < kDepth; ++i) {
    structure.structs[i].name = "g";
    if (i % 1000 == 1) structure.structs[i].body.emplace_back(translation(1, 0));
    structure.structs[i].body.emplace_back(StructId(i + 1));
  }
  structure.structs.back().body.emplace_back(model("0 0, 0 1"));
  structure.root = StructId(0);
  const auto set = evaluate(structure);
  CHECK(to_text(set.segments.at(0)) == "1000 0, 1000 1");
  const std::string& path = set.sources.at(0).path;
  CHECK(path.size() <= plumbline::kMaxPathText + 4);
  CHECK(path.substr(path.size() - 6) == "/g/...");
}

TEST_CASE("a path that was cut short grows again from where it was") {
  const std::string longest(plumbline::kMaxPathText, 'x');
  CHECK(listing(structure_of({{"", "", {StructId(1)}},
                              {"a", "", {StructId(2), StructId(3)}},
                              {longest, "", {StructId(3)}},
                              {"c", "", {model("0 0, 1 0")}}})) ==
        "0 0, 1 0 | (a/...)\n"
        "0 0, 1 0 | (a/c)\n");
}

TEST_CASE("structures that multiply beyond the limit are refused, up to it they are not") {
  std::vector<Struct> doubling(41);
  for (std::size_t i = 0; i < 40; ++i) doubling[i].body = {StructId(i + 1), StructId(i + 1)};
  CHECK_THROWS_AS(evaluate(structure_of(doubling), 10'000'000), plumbline::Error);
  // One item, and four integer coordinates of which one is 0: numerator and denominator each.
  const auto one = structure_of({{"", "", {model("1 1, 0 2")}}});
  CHECK_NOTHROW(evaluate(one, 1 + 7));
  CHECK_THROWS_AS(evaluate(one, 1 + 6), plumbline::Error);
}

TEST_CASE("nested maps that make monstrous numbers are refused") {
  std::vector<Struct> growing(100'000);
  for (std::size_t i = 0; i + 1 < growing.size(); ++i) {
    growing[i].body = {scaling(parse_decimal("1.1e4000"), 1), StructId(i + 1)};
  }
  try {
    evaluate(structure_of(growing));
    FAIL("no error");
  } catch (const plumbline::Error& error) {
    CHECK(error.code() == plumbline::ErrorCode::Limit);
  }
}

#include <catch2/catch.hpp>

#include <csignal>
#include <stdexcept>

#include "campaign/child.hpp"
#include "campaign/claims.hpp"
#include "campaign/dice.hpp"
#include "campaign/images.hpp"
#include "campaign/minimise.hpp"
#include "campaign/relations.hpp"
#include "inputs/families.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/output.hpp"
#include "support/engine_checks.hpp"
#include "support/segments.hpp"

using namespace plumbline;
using namespace plumbline::campaign;

namespace {

/// A triangle with a crossed antenna inside, and an isolated point.
const SegmentSet kInput = from_rows("0,0,4,0\n4,0,0,4\n0,4,0,0\n0,1,2,1\n1,0,1,2\n9,9\n");

bool is_valid(const ExactComplex& complex) { return validate(complex).empty(); }

}  // namespace

TEST_CASE("dice are splitmix64") {
  // The reference implementation's first numbers for seed 1234567.
  Dice dice(1234567);
  CHECK(dice.roll() == 6457827717110365317U);
  CHECK(dice.roll() == 3203168211198807973U);
  CHECK(dice.roll() == 9817491932198370423U);
}

TEST_CASE("a vertex on an edge cuts it; one on a vertex changes nothing") {
  const ExactComplex complex = arrange(kInput);
  const ExactComplex cut = with_vertex(complex, {3, 0});
  CHECK(is_valid(cut));
  CHECK(cut.vertices.size() == complex.vertices.size() + 1);
  CHECK(cut.edge_count() == complex.edge_count() + 1);
  CHECK(cut.face_count() == complex.face_count());
  CHECK(validate_coverage(cut, kInput).empty());
  CHECK(with_vertex(complex, {1, 1}) == complex);
  CHECK_THROWS_AS(with_vertex(complex, {7, 7}), Error);
}

TEST_CASE("the image under a map is a complex, turned over or not, and the inverse undoes it") {
  const ExactComplex complex = arrange(kInput);
  for (const Affine& map : {Affine(0, 1, 1, 0, 5, Rational(1, 3)), Affine(2, 1, 0, 3, 0, -1)}) {
    const ExactComplex image = mapped(complex, map);
    CHECK(is_valid(image));
    CHECK_FALSE(image == complex);
    CHECK(mapped(image, inverse(map)) == complex);
  }
  CHECK(determinant_sign(Affine(0, 1, 1, 0, 5, 0)) == -1);
  CHECK(determinant_sign(Affine(2, 1, 4, 2, 0, 0)) == 0);
}

TEST_CASE("with a copy far away everything is there twice, in one unbounded face") {
  const ExactComplex complex = arrange(kInput);
  const ExactComplex both = with_copy(complex, translation(100, 0), kInput.segments.size());
  CHECK(is_valid(both));
  CHECK(both.vertices.size() == 2 * complex.vertices.size());
  CHECK(both.edge_count() == 2 * complex.edge_count());
  CHECK(both.face_count() == 2 * complex.face_count() - 1);
  CHECK(both.component_count() == 2 * complex.component_count());
}

TEST_CASE("every relation holds for a right complex and fails for one with a vertex elsewhere") {
  const ExactComplex right = arrange(kInput);
  ExactComplex wrong = right;
  wrong.vertices.replace(0, {2, 3});  // across a side of the triangle
  for (const Relation relation : kRelations) {
    CAPTURE(to_text(relation));
    for (std::uint64_t seed = 0; seed < 20; ++seed) CHECK(holds(relation, kInput, right, seed));
    // Claims are about an answer, whatever it is held against.
    if (relation != Relation::Claims) CHECK_FALSE(holds(relation, kInput, wrong, 1));
  }
}

TEST_CASE("claims that are forged are refuted") {
  // Two ends 0.01 apart, which the radius of 0.1 merges.
  const Check right = check_lar(segments("0 0 1 0  1.01 0 2 0"), 0.1);
  REQUIRE(right.causes.size() == 1);
  CHECK(refuted_claim(right) == "");
  const auto refuted = [&](auto forge) {
    Check forged = right;
    forge(forged.causes[0]);
    return refuted_claim(forged) != "";
  };
  CHECK(refuted([](Cause& cause) { cause.radius_without = 0.05; }));
  CHECK(refuted([](Cause& cause) { cause.advice = "with radius 0.05 it is not there (tried)"; }));
  CHECK(refuted([](Cause& cause) { cause.advice = "with the least radius that there is, 0"; }));
  CHECK(refuted([](Cause& cause) { cause.advice = "a radius below 0.01 keeps them apart"; }));
  CHECK(refuted([](Cause& cause) { cause.stage = "intersect"; }));
  CHECK(refuted([](Cause& cause) { cause.round = 2; }));
  CHECK(refuted([](Cause& cause) { cause.stage = kParse; }));
  CHECK(refuted([](Cause& cause) { cause.stage = kDrawing; }));
}

TEST_CASE("a finding that rounding makes a part of is refuted as rounding's alone") {
  Check check = check_lar(segments("0 1 10 1  0 1.00000000000000000001 10 5  0 1.005 -3 9"));
  REQUIRE(check.causes.size() == 1);
  CHECK(refuted_claim(check) == "");
  const Cause parse = check.causes[0].with.at(0);
  check.causes[0] = parse;
  CHECK(refuted_claim(check) != "");
}

TEST_CASE("an input is made small: what can be left out goes, numbers become short") {
  // Fails where two segments cross properly.
  const auto crosses = [](const SegmentSet& set) {
    for (const Segment& s : set.segments) {
      for (const Segment& t : set.segments) {
        if (orientation(s.a, s.b, t.a) * orientation(s.a, s.b, t.b) < 0 &&
            orientation(t.a, t.b, s.a) * orientation(t.a, t.b, s.b) < 0) {
          return true;
        }
      }
    }
    return false;
  };
  SegmentSet input = inputs::of_family("near corners", 5);
  REQUIRE(crosses(input));
  REQUIRE(input.segments.size() > 4);
  const SegmentSet small = minimised(input, crosses);
  CHECK(crosses(small));
  CHECK(small.segments.size() == 2);
  CHECK(small.points.empty());
  // Four digits of coordinates per segment are enough for a cross.
  CHECK(to_lines(small).size() <= to_lines(from_rows("-1,-1,1,1\n-1,1,1,-1\n")).size());
}

TEST_CASE("rows are read as they are written") {
  const std::string text = "0,1/3,-2.5,4\n7,1e2\n";
  const SegmentSet set = from_rows(text);
  CHECK(to_lines(set) == "0,1/3,-2.5,4\n7,100\n");
  CHECK_THROWS_AS(from_rows("1,2,3\n"), Error);
  CHECK_THROWS_AS(from_rows("1,x\n"), Error);
}

TEST_CASE("whatever work does in a child is a result here") {
  CHECK(in_child([] { return std::string("done"); }, 60) == "done");
  const auto throwing = []() -> std::string { throw std::runtime_error("no"); };
  CHECK(in_child(throwing, 60) == "throws no");
  const auto killed = [] {
    std::signal(SIGSEGV, SIG_DFL);
    std::raise(SIGSEGV);
    return std::string();
  };
  CHECK(in_child(killed, 60) == "crash (signal 11)");
  const auto endless = []() -> std::string {
    for (volatile bool forever = true; forever;) {
    }
    return {};
  };
  CHECK(in_child(endless, 0.2) == "hang");
}

TEST_CASE("small inputs are small, and full places are not") {
  for (const std::string& family : inputs::families()) {
    CAPTURE(family);
    const bool is_full = inputs::cost(family) == inputs::Cost::FullPlace;
    std::size_t sum = 0;
    constexpr unsigned kInputs = 50;
    for (unsigned seed = 0; seed < kInputs; ++seed) {
      sum += inputs::of_family(family, seed, inputs::Extent::Small).segments.size();
    }
    CHECK((sum <= 15 * kInputs) == !is_full);
  }
}

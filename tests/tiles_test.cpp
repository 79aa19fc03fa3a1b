// Strips together are the arrangement in one piece.

#include "plumbline/tiles.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "inputs/families.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "support/segments.hpp"

using namespace plumbline;
using namespace plumbline::tiles;

namespace {

Totals in_one_piece(const SegmentSet& input) {
  const ExactComplex c = arrange(input);
  const Counts n = counts(c, c.vertices.size());
  return {n.vertices, n.edges, n.faces, n.holes, n.components, signature2(c)};
}

Bounds bounds_of(const SegmentSet& input) {
  const auto first = input.segments.numbers(0);
  Bounds b{first[0], first[1], first[0], first[1]};
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const auto n = input.segments.numbers(s);
    for (const std::size_t i : {0U, 2U}) {
      b.left = std::min(b.left, n[i]);
      b.right = std::max(b.right, n[i]);
      b.bottom = std::min(b.bottom, n[i + 1]);
      b.top = std::max(b.top, n[i + 1]);
    }
  }
  return b;
}

/// What meets the strip.
StripPart part_of(const SegmentSet& input, const Strip& strip, const Bounds& bounds) {
  SegmentSet within;
  std::vector<std::uint64_t> numbers;
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const auto n = input.segments.numbers(s);
    const Number &low = std::min(n[0], n[2]), &high = std::max(n[0], n[2]);
    if ((strip.left && high < *strip.left) || (strip.right && low > *strip.right)) continue;
    within.segments.push_back({n[0], n[1]}, {n[2], n[3]});
    numbers.push_back(s);
  }
  return strip_part(within, numbers, strip, bounds);
}

/// Cuts where a vertex lies give way.
Totals in_strips(const SegmentSet& input, std::vector<Number> cuts, int tries = 3) try {
  const Bounds bounds = bounds_of(input);
  std::vector<StripPart> parts;
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  for (std::size_t i = 0; i <= cuts.size(); ++i) {
    Strip strip;
    if (i > 0) strip.left = cuts[i - 1];
    if (i < cuts.size()) strip.right = cuts[i];
    parts.push_back(part_of(input, strip, bounds));
  }
  return merged(parts);
} catch (const CutThroughVertex&) {
  if (tries == 0) throw;
  for (Number& cut : cuts) cut = cut + Number(Rational(1, 104'729));
  return in_strips(input, cuts, tries - 1);
}

Number number(const std::string& text) { return Number(parse_decimal(text)); }

void check(const SegmentSet& input, const std::vector<Number>& cuts) {
  const Totals whole = in_one_piece(input), strips = in_strips(input, cuts);
  CHECK(strips.vertices == whole.vertices);
  CHECK(strips.edges == whole.edges);
  CHECK(strips.faces == whole.faces);
  CHECK(strips.holes == whole.holes);
  CHECK(strips.components == whole.components);
  CHECK(to_text(strips.signature) == to_text(whole.signature));
}

}  // namespace

TEST_CASE("a square cut in two is a square") {
  const SegmentSet square = segments("0 0 2 0  2 0 2 2  2 2 0 2  0 2 0 0");
  check(square, {});
  check(square, {number("0.7")});
  check(square, {number("0.7"), number("1.1")});
  check(square, {number("-5.5"), number("0.7"), number("5.5")});
}

TEST_CASE("rings within each other, cut anywhere, keep their holes") {
  std::string text;
  for (const int r : {1, 2, 3, 5, 9}) {
    const std::string a = std::to_string(-r), b = std::to_string(r);
    text += a + " " + a + " " + b + " " + a + "  " + b + " " + a + " " + b + " " + b + "  " + b +
            " " + b + " " + a + " " + b + "  " + a + " " + b + " " + a + " " + a + "  ";
  }
  check(segments(text), {number("-2.5"), number("0.1"), number("0.2"), number("4.1")});
  check(segments(text + "-20 0.5 20 0.5  6.5 6.5 7.5 7.5"), {number("-2.6"), number("7.1")});
}

TEST_CASE("random drawings of all families are the same in strips") {
  std::mt19937 random(5);
  for (const std::string& family : inputs::families()) {
    for (int round = 0; round < 40; ++round) {
      SegmentSet input = inputs::of_family(family, static_cast<unsigned>(random()));
      input.points.clear();
      input.point_source.clear();
      if (input.segments.empty()) continue;
      const Bounds b = bounds_of(input);
      std::vector<Number> cuts;
      const Rational width = b.right.rational() - b.left.rational();
      for (int i = 0; i < round % 5; ++i) {
        cuts.push_back(b.left + Number(width * Rational(static_cast<int>(random() % 1000), 1009)) +
                       Number(Rational(1, 7919)));
      }
      CAPTURE(family, round);
      check(input, cuts);
    }
  }
}

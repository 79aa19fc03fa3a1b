// What lies far away: told, and without effect on defaults and pictures.

#include <catch2/catch.hpp>

#include "plumbline/plumbline.hpp"

using namespace plumbline;

namespace {

/// Nine rooms of 4 x 3, and with `stray` a line 4,000 times their width away.
SegmentSet rooms_drawn(bool stray) {
  SegmentSet set;
  set.add_file("plan.dxf");
  const auto add = [&](PointD a, PointD b, const char* layer, std::uint32_t line) {
    Source source{0, line, 0, "LINE", {}, {}};
    source.layer = layer;
    set.add(a, b, set.add_source(source));
  };
  for (int i = 0; i < 4; ++i) {
    add({0, 3.0 * i}, {12, 3.0 * i}, "W", 10);
    add({4.0 * i, 0}, {4.0 * i, 9}, "W", 20);
  }
  if (stray) add({48000, 0}, {48001, 2}, "JUNK", 312);
  return set;
}

}  // namespace

TEST_CASE("an element far away is told once, with its layer and its place") {
  CHECK(stray_text(rooms_drawn(false)).empty());
  CHECK(stray_text(rooms_drawn(true)) ==
        "1 element lies 4,000 drawing sizes away: layer JUNK, plan.dxf:312 LINE");
}

TEST_CASE("an element far away changes no default") {
  const SegmentSet input = rooms_drawn(true), alone = rooms_drawn(false);
  const ExactComplex complex = arrange(input), without = arrange(alone);
  CHECK(diagnose(input, complex).within == Rational(3, 250));
  CHECK(diagnose(input, complex).within == diagnose(alone, without).within);
  CHECK(rooms(input, complex, {}).rooms.size() == 9);
  CHECK(rooms(alone, without, {}).rooms.size() == 9);
}

TEST_CASE("pictures show what is not far away, and say so") {
  const SegmentSet input = rooms_drawn(true);
  const ExactComplex complex = arrange(input);
  for (const std::string& svg : {to_svg(input), to_svg(complex)}) {
    CHECK_THAT(svg, Catch::Contains("1 segment far away, not shown"));
    CHECK_THAT(svg, Catch::Contains("viewBox=\"-0.24 -0.24 12.48 "));
  }
  CHECK_THAT(to_svg(diagnose(input, complex), input, complex),
             Catch::Contains("what lies far away is not shown"));
}

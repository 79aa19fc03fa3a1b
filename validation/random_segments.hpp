#pragma once

#include <random>
#include <string>

#include "plumbline/geometry.hpp"

/// Families of small random inputs that hurt an arrangement. Each is determined by its seed.
namespace random_segments {

inline const char* const kFamilies[] = {
    "lattice",         "slanted lattice", "nearly coincident", "star of thirds", "rotated",
    "near concurrent", "mixed scales",    "collinear",         "rings",          "long and short"};

inline plumbline::SegmentSet make(const std::string& family, unsigned seed) {
  using plumbline::Point;
  using plumbline::Rational;
  using plumbline::Segment;
  std::mt19937 random(seed);
  const auto pick = [&](unsigned count) { return static_cast<int>(random() % count); };
  const auto side = static_cast<unsigned>(2 + random() % 12);
  const int count = 2 + pick(random() % 4 == 0 ? 150 : 30);
  const auto lattice = [&] { return Point{pick(side), pick(side)}; };
  plumbline::SegmentSet set;
  const auto source = set.add_source({0, 0, 0, family, std::to_string(seed), ""});
  const Rational tiny(1, mpz_class("1000000000000000000000000000057"));
  const Rational c(1136689, 3136690), third(1, 3);
  for (int i = 0; i < count; ++i) {
    Segment s{lattice(), lattice()};
    if (family == "slanted lattice") s.b = {s.b.x / 3, s.b.y / 7};
    if (family == "nearly coincident") s.b.x += tiny * pick(3);
    if (family == "star of thirds") {
      s.a = {3 * s.a.x, 3 * s.a.y};
      s.b = {2 * third - s.a.x * (1 + pick(2)), 4 * third - s.a.y};
    }
    if (family == "rotated") {
      s.a = {s.a.x - c * s.a.y, s.a.y + c * s.a.x};
      s.b = {s.b.x - c * s.b.y, s.b.y + c * s.b.x};
    }
    if (family == "near concurrent") {
      const Rational dx = pick(201) - 100, dy = pick(201) - 100;
      s = {{-dx, -dy}, {dx + pick(3) - 1, dy + (pick(2) == 0 ? Rational(0) : tiny)}};
    }
    if (family == "mixed scales") {
      mpz_class scale;
      mpz_ui_pow_ui(scale.get_mpz_t(), 10, random() % 19);
      Rational factor(scale, mpz_class(1'000'000'000));
      factor.canonicalize();
      s.b = {s.a.x + factor * s.b.x, s.a.y + factor * s.b.y};
    }
    if (family == "collinear")
      s = {{s.a.x, 2 * s.a.x}, {s.b.x, 2 * s.b.x + (pick(4) == 0 ? 1 : 0)}};
    if (family == "rings") {
      const Point p = s.a, q{s.a.x + 1 + pick(3), s.a.y + 1 + pick(3)};
      set.add({p, {q.x, p.y}}, source);
      set.add({{q.x, p.y}, q}, source);
      set.add({q, {p.x, q.y}}, source);
      s = {{p.x, q.y}, p};
    }
    if (family == "long and short" && i > 0) {
      const Rational thousandth(1, 1000);
      s.b = {s.a.x + thousandth * pick(9), s.a.y + third / 500};
    }
    set.add(s, source);
  }
  if (random() % 3 == 0) {
    for (int i = 0; i < 4; ++i) set.add_point(lattice(), source);
  }
  set.rejected.clear();
  return set;
}

}  // namespace random_segments

#include "inputs/draw.hpp"

#include <algorithm>
#include <utility>

namespace plumbline::inputs {

Draw::Draw(const std::string& family, unsigned seed, Extent extent)
    : random_(seed),
      extent_(extent),
      source_(set_.add_source({0, 0, 0, family, std::to_string(seed), ""})) {}

int Draw::size(int usual, int most, int each) {
  constexpr int kUsual = 4, kMost = 12;
  if (extent_ == Extent::Usual) return one_in(16) ? between(usual, most) : between(2, usual);
  return ((one_in(16) ? between(kUsual, kMost) : between(2, kUsual)) + each - 1) / each;
}

Point Draw::vector(int reach) {
  Point v{between(-reach, reach), between(-reach, reach)};
  if (v.x == 0 && v.y == 0) v.x = 1;
  return v;
}

Rational Draw::fraction() {
  const int denominators[] = {2, 3, 7, 9, 11, 64, 97, 1000};
  const int denominator = denominators[pick(8)];
  Rational result(1 + pick(denominator - 1), denominator);
  result.canonicalize();
  return result;
}

Rational Draw::tiny() {
  switch (pick(4)) {
    case 0:
      return power_of_ten(-6);
    case 1:
      return power_of_ten(-15);
    case 2:
      return Rational(1, 3) * power_of_ten(-9);
    default:
      return {1, mpz_class("1000000000000000000000000000057")};
  }
}

Rational Draw::power_of_ten(int exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
  return exponent < 0 ? Rational(1, power) : Rational(power);
}

void Draw::add_ring(const std::vector<Point>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    add(corners[i], corners[(i + 1) % corners.size()]);
  }
}

Point Draw::any_point() {
  const Segment s = any();
  return s.a + fraction() * (s.b - s.a);
}

void Draw::add_points(int side) {
  if (!one_in(3)) return;
  for (int i = 0; i < 4; ++i) {
    const int where = empty() ? 2 : pick(3);
    set_.add_point(where == 0 ? any().a : where == 1 ? any_point() : lattice(side), source_);
  }
}

void Draw::rotate() {
  const Rational t(between(1, 40), 41);
  change([&](const Point& p) { return rotated(p, t); });
}

Point Draw::rotated(const Point& p, const Rational& t) {
  const Rational c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

void Draw::renumber() {
  const int kind = pick(5);
  if (kind == 1) rotate();
  if (kind == 2) {
    change([](const Point& p) { return Point{p.x / 3, p.y / 7}; });
  }
  if (kind >= 3) {
    // Some thousand of units become up to 2^30 (narrow or a little more) or 2^60.
    const mpz_class factor = (mpz_class(1) << (kind == 3 ? between(16, 22) : between(23, 50))) + 1;
    const mpz_class shift = one_in(2) ? (mpz_class(1) << between(20, 58)) + 3 : mpz_class(0);
    change([&](const Point& p) {
      Point q{factor * p.x + shift, factor * p.y - shift};
      if (one_in(16)) q.y += 1;
      return q;
    });
  }
}

SegmentSet Draw::take() {
  set_.rejected.clear();
  return std::move(set_);
}

}  // namespace plumbline::inputs

#include "inputs/families/scales_and_turns.hpp"

#include <cmath>

namespace plumbline::inputs {

void chain_of_scales(Draw& draw) {
  Point at = draw.lattice(5);
  for (int n = draw.size(20, 60); n > 0; --n) {
    const Rational scale = Draw::power_of_ten(draw.between(-9, 9));
    const Point next = at + scale * draw.vector(9);
    draw.add(draw.one_in(4) ? at - (next - at) : at, next);
    at = draw.one_in(2) ? next : draw.one_in(2) ? draw.any_point() : draw.any().a;
  }
  draw.add_points(5);
}

void lattices_turned(Draw& draw) {
  const int side = draw.between(2, 6), most = draw.between(1, 40);
  const Rational turns[] = {0, Rational(most, 41), Rational(1, draw.between(2, 99))};
  const Point centre = draw.lattice(side);
  const auto point = [&](const Rational& turn) {
    return Draw::rotated(draw.lattice(side) - centre, turn);
  };
  for (int n = draw.size(24, 80); n > 0; --n) {
    const Rational& turn = turns[draw.pick(3)];
    const Point a = point(turn);
    draw.add(a, point(draw.one_in(4) ? turns[draw.pick(3)] : turn));
  }
  draw.add_points(side);
}

void mixed_doubles(Draw& draw) {
  const int side = draw.between(2, 6);
  const auto corner = [&] {
    const Point p = draw.lattice(side);
    if (draw.one_in(2)) return p;
    const double unit = std::ldexp(1.0, draw.between(-80, 3));
    return exact(nearest(p + rational_from(unit) * draw.vector(9)));
  };
  for (int n = draw.size(32, 120); n > 0; --n) {
    const Point a = draw.empty() || draw.one_in(2) ? corner() : draw.any().b;
    draw.add(a, corner());
  }
  draw.add_points(side);
}

void lattice_turned_in_doubles(Draw& draw) {
  const int side = draw.between(2, 9);
  for (int n = draw.size(32, 150); n > 0; --n) {
    const Point a = draw.lattice(side);
    draw.add(a, draw.one_in(3) ? draw.lattice(side) : a + Point{draw.pick(3), 0});
  }
  draw.add_points(side);
  const Rational half_tangent(draw.between(1, 40), 41);
  draw.change([&](const Point& p) { return exact(nearest(Draw::rotated(p, half_tangent))); });
}

void lattice_and_strays(Draw& draw) {
  const int side = draw.between(2, 9);
  const Rational far = Draw::power_of_ten(draw.between(9, 40));
  for (int n = draw.size(32, 150); n > 0; --n) {
    const Point a = draw.lattice(side), b = draw.lattice(side);
    if (draw.one_in(12)) {
      draw.add(draw.one_in(2) ? a : far * a + b, far * (a + draw.vector(3)) - b);
    } else {
      draw.add(a, b);
    }
  }
  draw.add_points(side);
}

}  // namespace plumbline::inputs

#include "inputs/families/scales_and_turns.hpp"

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

}  // namespace plumbline::inputs

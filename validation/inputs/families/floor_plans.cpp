#include "inputs/families/floor_plans.hpp"

namespace plumbline::inputs {
namespace {

/// A wall from a to b: two lines, `thick` apart, closed at its ends or not.
struct Wall {
  Point a, b;
  Point thick;  ///< across the wall
};

void add_plain(Draw& draw, const Wall& wall, const Rational& unit) {
  const Point beyond = draw.one_in(6) ? unit * (wall.b - wall.a) : Point{0, 0};
  draw.add(wall.a, wall.b + beyond);
  draw.add(wall.a + wall.thick, wall.b + wall.thick);
  if (draw.one_in(4)) draw.add(wall.b, wall.b + wall.thick);
}

void add_with_door(Draw& draw, const Wall& wall) {
  const Point along = wall.b - wall.a;
  const Rational open = draw.fraction() / 2, width = draw.fraction() / 2;
  const Point p = wall.a + open * along, q = p + width * along;
  for (const Point& side : {Point{0, 0}, wall.thick}) {
    draw.add(wall.a + side, p + side);
    draw.add(q + side, wall.b + side);
  }
  draw.add(p, p + wall.thick);
  draw.add(q, q + wall.thick);
  const Rational t = Rational(draw.between(1, 41)) / 41;
  draw.add(p, p + Draw::rotated(q - p, draw.one_in(2) ? t : Rational(-t)));
}

}  // namespace

void floor_plan(Draw& draw) {
  const Rational unit = draw.tiny();
  const Rational thick = Rational(draw.between(1, 3)) / (draw.one_in(2) ? 8 : 10);
  const int step = draw.between(2, 5);
  int walls = draw.size(5, 15, 4);
  if (draw.one_in(2)) {
    const Point far{step * draw.between(1, 3), step * draw.between(1, 3)};
    draw.add_ring({{0, 0}, {far.x, 0}, far, {0, far.y}});
    --walls;
  }
  for (; walls > 0; --walls) {
    const Point a = Rational(step) * draw.lattice(4);
    const Rational length = step * draw.between(1, 2);
    const bool upright = draw.one_in(2);
    const Wall wall = upright ? Wall{a, a + Point{0, length}, {thick, 0}}
                              : Wall{a, a + Point{length, 0}, {0, thick}};
    draw.one_in(3) ? add_with_door(draw, wall) : add_plain(draw, wall, unit);
  }
  if (draw.one_in(3)) draw.rotate();
  draw.add_points(4 * step);
}

}  // namespace plumbline::inputs

#include "inputs/families/near_misses.hpp"

namespace plumbline::inputs {
namespace {

/// The point itself, or one that is a few units off.
Point about(Draw& draw, const Point& p, const Rational& unit) {
  return draw.one_in(2) ? p : p + unit * draw.vector(2);
}

}  // namespace

void near_concurrent_fans(Draw& draw) {
  const Rational unit = draw.tiny();
  // Two segments a + [0, 1] u and b + [0, 1] v that cross at the apex, at rational parameters.
  const Point u = draw.vector(9), v = draw.vector(9), a = draw.lattice(7);
  const Point apex = a + draw.fraction() * u;
  const Point b = apex - draw.fraction() * v;
  draw.add(a, a + u);
  draw.add(b, b + v);
  for (int n = draw.size(16, 60, 2); n > 0; --n) {
    const Point d = draw.vector(9), centre = about(draw, apex, unit);
    switch (draw.pick(3)) {
      case 0:  // ends there
        draw.add(centre, centre + d);
        break;
      case 1:  // goes through
        draw.add(centre - draw.fraction() * d, centre + d);
        break;
      default:  // along one of the two, from there
        draw.add(centre, draw.one_in(2) ? a : b + v);
    }
  }
  draw.add_points(7);
}

void near_coincident_corners(Draw& draw) {
  const Rational unit = draw.tiny();
  std::vector<Point> places;
  for (int n = draw.between(3, 6); n > 0; --n) {
    const Point p = draw.lattice(5);
    places.push_back(draw.one_in(2) ? p : draw.fraction() * p);
  }
  const auto corner = [&] {
    return about(draw, places[static_cast<std::size_t>(draw.pick(static_cast<int>(places.size())))],
                 unit);
  };
  for (int n = draw.size(8, 30, 3); n > 0; --n) {
    std::vector<Point> corners;
    for (int k = draw.between(3, 4); k > 0; --k) corners.push_back(corner());
    draw.add_ring(corners);
  }
  draw.add_points(5);
}

void t_junctions_on_slants(Draw& draw) {
  const Rational unit = draw.tiny();
  const Point origin = draw.lattice(5);
  draw.add(origin, origin + Point{draw.between(1, 13), draw.between(1, 13)});
  Point foot = draw.any_point();
  for (int n = draw.size(20, 60); n > 0; --n) {
    const Segment wall = draw.any();
    const Point along = wall.b - wall.a;
    const Point across{-along.y, along.x};
    if (!draw.one_in(3)) foot = wall.a + draw.fraction() * along;  // else the one before, again
    Point end = foot;
    if (draw.one_in(3)) end = end + unit * (draw.one_in(2) ? across : along);
    const Rational side = draw.one_in(2) ? 1 : -1;
    draw.add(end, draw.one_in(2) ? end + side * draw.fraction() * across : end + draw.vector(6));
  }
  draw.add_points(9);
}

}  // namespace plumbline::inputs

#include "inputs/families/full_places.hpp"

#include "inputs/draw.hpp"

namespace plumbline::inputs {
namespace {

/// More than a bucket tests pair by pair; seldom many more.
int many(Draw& draw, int most) {
  return draw.one_in(16) ? draw.between(60, most) : draw.between(26, 45);
}

constexpr int kReach = 500;

/// A segment along d that has p inside, or as an end.
void add_through(Draw& draw, const Point& p, const Point& d) {
  const int back = draw.one_in(8) ? 0 : draw.between(1, 3);
  draw.add(p - back * d, p + draw.between(1, 3) * d);
}

/// Segments that cross the others, end on them, or go through their ends.
void add_others(Draw& draw, int count) {
  for (; count > 0; --count) {
    const Point p = draw.any_point(), q = draw.one_in(2) ? draw.any().a : draw.any_point();
    const int kind = draw.pick(3);
    if (kind == 0) draw.add(p, p + draw.vector(kReach));
    if (kind == 1) draw.add(p, q);
    if (kind == 2) draw.add(p - (q - p), q + (q - p));
  }
}

}  // namespace

void pencils(Draw& draw) {
  const int apart[] = {1, 2, 40, 400};
  const int reach = apart[draw.pick(4)];
  std::vector<Point> centres;
  for (int n = draw.between(2, 4); n > 0; --n) centres.push_back(draw.vector(reach));
  const auto any_centre = [&] {
    return centres[static_cast<std::size_t>(draw.pick(static_cast<int>(centres.size())))];
  };
  for (int n = many(draw, 120); n > 0; --n) {
    const Point p = any_centre(), q = any_centre();
    const bool through_both = draw.one_in(8) && !(p == q);
    add_through(draw, p, through_both ? q - p : draw.vector(kReach));
  }
  if (draw.one_in(2)) add_others(draw, 3);
  draw.add_points(3);
  draw.renumber();
}

void near_pencils(Draw& draw) {
  const int reach = draw.one_in(2) ? kReach : 100'000'000;
  const Point centre = draw.vector(9);
  for (int n = many(draw, 90); n > 0; --n) {
    const Point d = draw.vector(reach);
    Point a = centre - d, b = centre + draw.between(1, 3) * d;
    if (draw.one_in(3)) a = a + draw.vector(1);
    if (draw.one_in(6)) b = centre + draw.vector(1);
    draw.add(a, b);
  }
  draw.add_points(9);
  if (reach == kReach) draw.renumber();
}

void fan(Draw& draw) {
  const Point apex = draw.vector(9);
  const int narrow = draw.one_in(2) ? kReach : 20;
  for (int n = many(draw, 300); n > 0; --n) {
    const Point d{kReach, draw.between(-narrow, narrow)};
    draw.add(apex, apex + draw.between(1, 3) * d);
    if (draw.one_in(20)) draw.add(apex - d, apex + draw.pick(2) * d);
  }
  add_others(draw, draw.pick(5));
  draw.add_points(9);
  draw.renumber();
}

void hatch(Draw& draw) {
  const Point direction = draw.vector(40), step = draw.vector(3);
  const int most = draw.one_in(4) ? 5 : 100;  // few supporting lines, or many
  for (int n = many(draw, 200); n > 0; --n) {
    const Point origin = draw.pick(most) * step;
    const Point p = origin + draw.between(-5, 5) * direction;
    draw.add(p, p + draw.between(1, 5) * direction);
  }
  add_others(draw, draw.pick(6));
  draw.add_points(9);
  draw.renumber();
}

void pencil_in_bundle(Draw& draw) {
  const Point centre = draw.vector(9), direction = draw.vector(kReach), step = draw.vector(2);
  const int parallel = many(draw, 60);
  for (int n = 0; n < parallel; ++n) {
    const Point p = centre + draw.between(-parallel / 2, parallel / 2) * step;
    draw.add(p - draw.pick(2) * direction, p + direction);
  }
  for (int n = draw.between(13, 30); n > 0; --n) {
    const Point aside = draw.vector(draw.one_in(2) ? 40 : kReach);
    add_through(draw, centre, draw.one_in(2) ? direction + aside : aside);
  }
  draw.add_points(9);
  draw.renumber();
}

void stars_on_lattice(Draw& draw) {
  const int side = draw.between(2, 4);
  const auto point = [&] { return Rational(1, 3) * draw.lattice(side); };
  for (int n = many(draw, 200); n > 0; --n) {
    const Point p = point(), q = point();
    draw.add(p, draw.one_in(4) ? q + (q - p) : q);
  }
  draw.add_points(side);
  if (draw.one_in(2)) draw.renumber();
}

}  // namespace plumbline::inputs

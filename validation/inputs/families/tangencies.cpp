#include "inputs/families/tangencies.hpp"

namespace plumbline::inputs {
namespace {

/// The grid lines of a parallelogram: columns along v and rows along u.
void add_grid(Draw& draw, const Point& corner, const Point& u, const Point& v, int columns,
              int rows) {
  for (int i = 0; i <= columns; ++i) {
    const Point foot = corner + Rational(i) / columns * u;
    draw.add(foot, foot + v);
  }
  for (int i = 0; i <= rows; ++i) {
    const Point foot = corner + Rational(i) / rows * v;
    draw.add(foot, foot + u);
  }
}

/// A polygon with one corner on each of some sides of the ring: inscribed, so it touches there.
std::vector<Point> inscribed(Draw& draw, const std::vector<Point>& ring) {
  std::vector<Point> corners;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring.size() > 3 && draw.one_in(4)) continue;
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    corners.push_back(draw.one_in(4) ? a : a + draw.fraction() * (b - a));
  }
  return corners;
}

}  // namespace

void tangent_grids(Draw& draw) {
  const Point u{draw.between(1, 6), draw.between(0, 2)}, v{draw.between(-1, 1), draw.between(3, 6)};
  const Point corner = draw.lattice(5);
  const int most = draw.size(2, 5, 3);
  const int columns = draw.between(1, most), rows = draw.between(1, most);
  add_grid(draw, corner, u, v, columns, rows);
  Point start = corner + u;                                 // side by side
  if (draw.one_in(3)) start = corner + u + v;               // at a corner
  if (draw.one_in(3)) start = start + draw.fraction() * v;  // shifted along the side
  const Point across = draw.one_in(2) ? u : u + draw.fraction() * v;
  const Point up = draw.one_in(4) ? v + draw.fraction() * u : v;
  const Point height = draw.one_in(2) ? up : draw.fraction() * up;
  add_grid(draw, start, across, height, draw.between(1, most), rows);
  if (draw.one_in(4)) draw.rotate();
  draw.add_points(6);
}

void rings_touching_at_points(Draw& draw) {
  const Point origin = draw.lattice(5);
  std::vector<Point> ring{origin, origin + Point{draw.between(2, 9), draw.between(0, 1)},
                          origin + Point{draw.between(2, 9), draw.between(2, 9)}};
  if (draw.one_in(2)) ring.push_back(origin + Point{0, draw.between(2, 9)});
  draw.add_ring(ring);
  for (int n = draw.size(5, 13, 6); n > 0; --n) {
    const std::vector<Point> inner = inscribed(draw, ring);
    if (inner.size() < 2) break;
    draw.add_ring(inner);
    // Or a sibling: a triangle in the same ring that touches it at a corner only.
    if (draw.one_in(3)) {
      const Point a = ring[0], b = a + draw.fraction() * (ring[1] - a);
      draw.add_ring({a, b, a + draw.fraction() * (ring[2] - a)});
    }
    if (inner.size() >= 3) ring = inner;
  }
  if (draw.one_in(4)) draw.rotate();
  draw.add_points(6);
}

}  // namespace plumbline::inputs

#include "inputs/families.hpp"

#include <stdexcept>

#include "inputs/curve_scenes.hpp"
#include "inputs/draw.hpp"
#include "inputs/families/floor_plans.hpp"
#include "inputs/families/full_places.hpp"
#include "inputs/families/near_misses.hpp"
#include "inputs/families/scales_and_turns.hpp"
#include "inputs/families/tangencies.hpp"
#include "plumbline/read.hpp"

namespace plumbline::inputs {
namespace {

void lattice(Draw& draw) {
  const int side = draw.between(2, 13);
  for (int n = draw.size(32, 150); n > 0; --n) {
    const Point a = draw.lattice(side);
    draw.add(a, draw.lattice(side));
  }
  draw.add_points(side);
}

void slanted_lattice(Draw& draw) {
  const int side = draw.between(2, 13);
  for (int n = draw.size(32, 150); n > 0; --n) {
    const Point a = draw.lattice(side), b = draw.lattice(side);
    draw.add(a, {b.x / 3, b.y / 7});
  }
  draw.add_points(side);
}

void near_corners(Draw& draw) {
  const int side = draw.between(2, 6);
  const Rational unit = draw.tiny();
  const auto corner = [&] {
    const Point p = draw.lattice(side);
    return p + unit * Point{draw.between(-1, 1), draw.between(-1, 1)};
  };
  for (int n = draw.size(32, 120); n > 0; --n) {
    const Point a = corner();
    draw.add(a, corner());
  }
  draw.add_points(side);
}

void star_of_thirds(Draw& draw) {
  const int side = draw.between(2, 13);
  for (int n = draw.size(32, 150); n > 0; --n) {
    const Point a = 3 * draw.lattice(side);
    draw.add(a, {Rational(2, 3) - a.x * (1 + draw.pick(2)), Rational(4, 3) - a.y});
  }
  draw.add_points(side);
}

/// Lines that miss the origin by nothing, a little, or a unit.
void near_concurrent(Draw& draw) {
  const Rational unit = draw.tiny();
  for (int n = draw.size(32, 100); n > 0; --n) {
    const Point d = draw.vector(100);
    const Rational off = draw.one_in(2) ? Rational(0) : unit;
    draw.add({-d.x, -d.y}, {d.x + draw.between(-1, 1), d.y + off});
  }
}

void mixed_scales(Draw& draw) {
  const int side = draw.between(2, 13);
  for (int n = draw.size(32, 150); n > 0; --n) {
    const Point a = draw.lattice(side), d = draw.lattice(side);
    draw.add(a, a + Draw::power_of_ten(draw.between(-9, 9)) * d);
  }
  draw.add_points(side);
}

/// Squares and spokes around one point, from 1e-9 to 1e9.
void nested_scales(Draw& draw) {
  const Point centre{Rational(draw.pick(3)) / 3, Rational(draw.pick(3)) / 7};
  for (int n = draw.size(14, 14, 4); n > 0; --n) {
    const Point u = Draw::power_of_ten(draw.between(-9, 9)) * draw.vector(3), v{-u.y, u.x};
    draw.add_ring({centre + u, centre + v, centre - u, centre - v});
    if (draw.one_in(2)) draw.add(centre - 2 * u, centre + draw.pick(3) * v);
  }
  draw.add_points(2);
}

void collinear(Draw& draw) {
  const int side = draw.between(2, 13);
  for (int n = draw.size(32, 150); n > 0; --n) {
    const int a = draw.pick(side), b = draw.pick(side);
    draw.add({a, 2 * a}, {b, 2 * b + (draw.one_in(4) ? 1 : 0)});
  }
  draw.add_points(side);
}

void rings(Draw& draw) {
  const int side = draw.between(2, 13);
  for (int n = draw.size(16, 50, 4); n > 0; --n) {
    const Point p = draw.lattice(side), q = p + Point{draw.between(1, 3), draw.between(1, 3)};
    draw.add_ring({p, {q.x, p.y}, q, {p.x, q.y}});
  }
  draw.add_points(side);
}

/// Triangles nested in each other or side by side that share a corner, or have one on a side.
void touching_rings(Draw& draw) {
  const Rational unit(1, draw.between(1, 3));
  const Point p = unit * draw.lattice(4);
  for (int n = draw.size(8, 8, 3); n > 0; --n) {
    const Rational size = unit * draw.between(-9, 9);
    const Point u = size * draw.vector(9), v = size * draw.vector(9);
    const Point corner = draw.empty() || draw.one_in(2) ? p : draw.any_point();
    draw.add_ring({corner, corner + u, corner + v});
    if (draw.one_in(3)) {
      const Point inside = corner + draw.fraction() * (u + v);
      draw.add_ring({corner, inside, corner + draw.fraction() * v});
    }
  }
  draw.add_points(4);
}

/// Ends on slanted segments at places that are no decimals, or a little off.
void t_junctions(Draw& draw) {
  const int side = draw.between(3, 13);
  const Rational unit = draw.tiny();
  draw.add(draw.lattice(side), {side, side + 1});
  for (int n = draw.size(24, 60); n > 0; --n) {
    if (draw.one_in(3)) {
      const Point a = draw.lattice(side);
      draw.add(a, draw.lattice(side));
      continue;
    }
    Point foot = draw.any_point();
    if (draw.one_in(3)) foot = foot + unit * draw.vector(1);
    draw.add(foot, draw.one_in(4) ? foot + draw.vector(5) : draw.lattice(side));
  }
  draw.add_points(side);
}

/// Rooms divided by walls that end exactly on others, seldom a little before or behind.
void plan(Draw& draw) {
  struct Room {
    Rational x0, y0, x1, y1;
  };
  const Rational unit = draw.tiny();
  std::vector<Room> rooms{{0, 0, draw.between(3, 30), draw.between(3, 30)}};
  draw.add_ring({{0, 0}, {rooms[0].x1, 0}, {rooms[0].x1, rooms[0].y1}, {0, rooms[0].y1}});
  for (int n = draw.size(30, 80, 2); n > 0; --n) {
    const auto r = static_cast<std::size_t>(draw.pick(static_cast<int>(rooms.size())));
    const Room room = rooms[r];
    const Rational t = draw.fraction();
    const Rational off = draw.one_in(6) ? unit * draw.between(-1, 1) : Rational(0);
    Room rest = room;
    if (draw.one_in(2)) {
      rooms[r].x1 = rest.x0 = room.x0 + t * (room.x1 - room.x0);
      draw.add({rest.x0, room.y0}, {rest.x0, room.y1 + off});
    } else {
      rooms[r].y1 = rest.y0 = room.y0 + t * (room.y1 - room.y0);
      draw.add({room.x0 + off, rest.y0}, {room.x1, rest.y0});
    }
    rooms.push_back(rest);
  }
  draw.add_points(3);
}

void rotated_plan(Draw& draw) {
  plan(draw);
  draw.rotate();
}

void rotated_lattice(Draw& draw) {
  lattice(draw);
  draw.rotate();
}

void long_and_short(Draw& draw) {
  const int side = draw.between(2, 13);
  draw.add({0, draw.pick(side)}, {side, side / 2});
  for (int n = draw.size(32, 150); n > 0; --n) {
    const Point a = draw.lattice(side);
    draw.add(a, a + Point{Rational(draw.pick(9)) / 1000, Rational(1, 1500)});
  }
  draw.add_points(side);
}

/// Curves as they are read, one scene or two over each other.
void scenes_of_curves(Draw& draw) {
  for (int n = draw.between(1, 2); n > 0; --n) {
    constexpr int kScenes = 1'000'000;
    const CurveScene scene = curve_scene(static_cast<std::uint64_t>(draw.pick(kScenes)));
    const SegmentSet drawn = evaluate(scene.file == "scene.svg" ? read_svg(scene.text, scene.file)
                                                                : read_dxf(scene.text, scene.file));
    for (const Segment& s : drawn.segments) draw.add(s.a, s.b);
  }
}

struct Maker {
  std::string family;
  void (*make)(Draw&);
  Cost cost = Cost::Cheap;
};

const std::vector<Maker>& makers() {
  static const std::vector<Maker> all = {
      {"lattice", lattice},
      {"slanted lattice", slanted_lattice},
      {"rotated lattice", rotated_lattice},
      {"near corners", near_corners, Cost::Dear},
      {"star of thirds", star_of_thirds},
      {"near concurrent", near_concurrent, Cost::Dear},
      {"mixed scales", mixed_scales},
      {"nested scales", nested_scales},
      {"collinear", collinear},
      {"rings", rings},
      {"touching rings", touching_rings, Cost::Dear},
      {"T-junctions", t_junctions, Cost::Dear},
      {"plan", plan, Cost::Dear},
      {"rotated plan", rotated_plan, Cost::Dear},
      {"long and short", long_and_short},
      {"near-concurrent fans", near_concurrent_fans, Cost::Dear},
      {"near-coincident corners", near_coincident_corners, Cost::Dear},
      {"T-junctions on slants", t_junctions_on_slants, Cost::Dear},
      {"tangent grids", tangent_grids, Cost::Dear},
      {"rings touching at points", rings_touching_at_points, Cost::Dear},
      {"floor plan", floor_plan},
      {"chain of scales", chain_of_scales},
      {"lattices turned", lattices_turned},
      {"mixed doubles", mixed_doubles, Cost::Dear},
      {"lattice turned in doubles", lattice_turned_in_doubles, Cost::Dear},
      {"lattice and strays", lattice_and_strays},
      {"scenes of curves", scenes_of_curves, Cost::FullPlace},
      {"pencils", pencils, Cost::FullPlace},
      {"near pencils", near_pencils, Cost::FullPlace},
      {"fan", fan, Cost::FullPlace},
      {"hatch", hatch, Cost::FullPlace},
      {"pencil in a bundle", pencil_in_bundle, Cost::FullPlace},
      {"stars on a small lattice", stars_on_lattice, Cost::FullPlace},
  };
  return all;
}

const Maker& maker_of(const std::string& family) {
  for (const Maker& maker : makers()) {
    if (maker.family == family) return maker;
  }
  throw std::out_of_range("no family of random segments: " + family);
}

}  // namespace

const std::vector<std::string>& families() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const Maker& maker : makers()) result.push_back(maker.family);
    return result;
  }();
  return names;
}

Cost cost(const std::string& family) { return maker_of(family).cost; }

SegmentSet of_family(const std::string& family, unsigned seed, Extent extent) {
  const Maker& maker = maker_of(family);
  Draw draw(family, seed, extent);
  maker.make(draw);
  return draw.take();
}

}  // namespace plumbline::inputs

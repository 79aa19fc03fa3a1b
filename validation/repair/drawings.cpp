#include "repair/drawings.hpp"

#include <algorithm>
#include <functional>

#include "inputs/draw.hpp"

namespace plumbline::repairs {
namespace {

using inputs::operator+;
using inputs::operator-;
using inputs::operator*;

struct Stroke {
  Point a, b;
};
using Strokes = std::vector<Stroke>;

constexpr int kSide = 8;  ///< of a drawing
constexpr int kParts = 100;
constexpr const char* kAnchors = "anchors";

Rational hundredths(int count) { return Rational(count) / kParts; }

/// A room, split into two by walls of one line or two until rooms are small.
void add_rooms(Strokes& all, Dice& dice, const Point& low, const Point& high, int depth) {
  const Rational width = high.x - low.x, height = high.y - low.y;
  if (depth == 0 || width < 2 || height < 2) return;
  const Rational part = hundredths(dice.between(kParts / 4, 3 * kParts / 4));
  const Rational thick = dice.one_in(3) ? hundredths(dice.between(5, 40)) : Rational(0);
  const bool upright = dice.one_in(2);
  const Rational at = (upright ? low.x : low.y) + part * (upright ? width : height);
  const auto wall = [&](const Rational& c) {
    all.push_back(upright ? Stroke{{c, low.y}, {c, high.y}} : Stroke{{low.x, c}, {high.x, c}});
  };
  wall(at);
  if (sgn(thick) > 0) wall(at + thick);
  const Rational next = at + thick;
  add_rooms(all, dice, low, upright ? Point{at, high.y} : Point{high.x, at}, depth - 1);
  add_rooms(all, dice, upright ? Point{next, low.y} : Point{low.x, next}, high, depth - 1);
}

Strokes plan(Dice& dice) {
  const Point low{0, 0}, high{kSide, dice.between(4, kSide)};
  Strokes all = {{low, {high.x, low.y}},
                 {{high.x, low.y}, high},
                 {high, {low.x, high.y}},
                 {{low.x, high.y}, low}};
  add_rooms(all, dice, low, high, dice.between(1, 3));
  if (dice.one_in(4)) all.push_back({low, high});
  return all;
}

Strokes hatch(Dice& dice) {
  Strokes all;
  const int lines = dice.between(3, 12);
  const Rational step = hundredths(dice.between(1, 60)), skew = hundredths(dice.between(0, 80));
  for (int i = 0; i < lines; ++i) all.push_back({{i * step, 0}, {i * step + skew, 2}});
  if (dice.one_in(2)) all.push_back({{-1, 0}, {lines * step + 1, 0}});
  if (dice.one_in(2)) all.push_back({{-1, 2}, {lines * step + 1, 2}});
  return all;
}

Strokes comb(Dice& dice) {
  Strokes all = {{{0, 0}, {kSide, 0}}};
  const int teeth = dice.between(3, 12);
  for (int i = 0; i < teeth; ++i) {
    const Rational x = hundredths(dice.between(0, kSide * kParts));
    const Rational y = hundredths(dice.between(-20, 20)), end = hundredths(dice.between(1, 300));
    all.push_back({{x, dice.one_in(2) ? Rational(0) : y}, {x, dice.one_in(3) ? -end : end}});
  }
  return all;
}

Strokes star(Dice& dice) {
  Strokes all;
  const int rays = dice.between(3, 8);
  const Point centre{3, 3};
  for (int i = 0; i < rays; ++i) {
    const Point way{dice.between(-4, 4), dice.between(-4, 4)};
    const Rational short_by = hundredths(dice.between(-20, 20));
    if (way == Point{0, 0}) continue;
    all.push_back({centre + short_by * way, centre + way});
  }
  return all;
}

Strokes chain(Dice& dice) {
  Strokes all;
  const int pieces = dice.between(2, 10);
  const Point way{dice.between(1, 3), dice.between(-3, 3)};
  Rational at = 0;
  for (int i = 0; i < pieces; ++i) {
    const Rational next = at + hundredths(dice.between(1, 60));
    all.push_back({at * way, next * way});
    at = next + hundredths(dice.between(-30, 30));
  }
  if (dice.one_in(2)) all.push_back({{1, -4}, {1, 4}});
  if (dice.one_in(3)) all.push_back({{1, -4}, {hundredths(dice.between(90, 110)), 4}});
  return all;
}

/// Chords of a circle, their ends printed with two or three decimals.
Strokes curve(Dice& dice) {
  Strokes all;
  const int chords = dice.between(4, 16), scale = dice.one_in(2) ? kParts : 10 * kParts;
  std::vector<Point> points;
  for (int i = 0; i <= chords; ++i) {
    // The rational circle: t = tan of half the angle, up to a right angle.
    const Rational t = Rational(i) / chords, n = 1 + t * t;
    Point p{3 * (1 - t * t) / n, 6 * t / n};
    for (Rational* x : {&p.x, &p.y}) {
      mpz_class whole;
      const Rational scaled = *x * scale;
      mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
      *x = Rational(whole) / scale;
    }
    points.push_back(p);
  }
  for (int i = 0; i < chords; ++i) {
    all.push_back({points[static_cast<std::size_t>(i)], points[static_cast<std::size_t>(i) + 1]});
  }
  all.push_back({{0, 0}, points.front()});
  all.push_back({{0, 0}, points.back()});
  return all;
}

Strokes bundle(Dice& dice) {
  Strokes all;
  const int lines = dice.between(3, 9);
  for (int i = 0; i < lines; ++i) {
    const Rational y = hundredths(dice.between(0, 40)), z = hundredths(dice.between(0, 40));
    all.push_back({{hundredths(dice.between(-50, 50)), y}, {6, z}});
  }
  if (dice.one_in(2)) all.push_back({{2, -1}, {2, 2}});
  return all;
}

Strokes lattice(Dice& dice) {
  Strokes all;
  const int lines = dice.between(3, 14), side = dice.between(2, 5);
  for (int i = 0; i < lines; ++i) {
    const auto point = [&] { return Point{dice.between(0, side), dice.between(0, side)}; };
    all.push_back({point(), point()});
  }
  return all;
}

Strokes sound(Dice& dice) {
  static const std::vector<std::function<Strokes(Dice&)>> families = {
      plan, plan, plan, hatch, comb, star, chain, curve, bundle, lattice};
  Strokes all = families[static_cast<std::size_t>(dice.pick(families.size()))](dice);
  if (!dice.one_in(4)) return all;
  const Point away{dice.between(-3, 3), dice.between(-3, 3)};
  for (Stroke s : families[static_cast<std::size_t>(dice.pick(families.size()))](dice)) {
    s.a = s.a + away;
    s.b = s.b + away;
    all.push_back(s);
  }
  return all;
}

/// One stroke, damaged by about d: its ends moved along it or anywhere, a copy beside it, cut in
/// two.
void damage(Strokes& all, std::size_t i, const Rational& d, Dice& dice) {
  const Point along = all[i].b - all[i].a;
  if (along == Point{0, 0}) return;
  const auto some = [&](int least) -> Rational { return d * dice.between(least, 32) / 32; };
  const Rational length = std::max(Rational(abs(along.x)), Rational(abs(along.y)));
  const Point unit = Rational(1 / length) * along;  // from 1 to sqrt(2) long
  const Point across{-unit.y, unit.x};
  Stroke copy = all[i];
  switch (dice.pick(6)) {
    case 0:
      all[i].a = all[i].a + some(-32) * unit;
      break;
    case 1:
      all[i].b = all[i].b + some(-32) * unit;
      break;
    case 2:
      copy.a = copy.a + some(-32) * across + some(0) * unit;
      copy.b = copy.b + (dice.one_in(2) ? copy.a - all[i].a : some(-32) * across);
      all.push_back(copy);
      break;
    case 3:
      all[i].b = all[i].b + Point{some(-32), some(-32)};
      break;
    case 4:
      copy.a = all[i].a + hundredths(dice.between(10, 90)) * along;
      all[i].b = copy.a - some(0) * unit;
      all.push_back(copy);
      break;
    default:
      if (dice.one_in(2)) all.push_back(copy);
  }
}

Point turned(const Point& p) { return {(3 * p.x - 4 * p.y) / 5, (4 * p.x + 3 * p.y) / 5}; }

void move_all(Strokes& all, Dice& dice) {
  const int turns = dice.pick(4);  // 0: none
  const Rational scale = dice.one_in(8) ? Rational(1, 3) : Rational(1);
  const Point away = dice.one_in(8) ? Point{1000000, -1000000} : Point{0, 0};
  for (Stroke& s : all) {
    for (Point* p : {&s.a, &s.b}) {
      if (turns == 1) *p = turned(*p);
      if (turns == 2) *p = {-p->y, p->x};
      *p = away + scale * *p;
    }
  }
}

/// Mostly near d; sometimes none, or as large as rooms.
Rational tolerance(const Rational& d, Dice& dice) {
  switch (dice.pick(8)) {
    case 0:
    case 1:
      return 0;
    case 2:
      return d / 2;
    case 3:
      return 2 * d;
    case 4:
      return dice.between(1, kSide);
    default:
      return d;
  }
}

RepairOptions options(const Rational& d, bool has_anchors, Dice& dice) {
  RepairOptions result;
  for (auto* each : {&result.weld, &result.grow, &result.trim, &result.sliver}) {
    if (!dice.one_in(10)) *each = tolerance(d, dice);
  }
  if (dice.one_in(6)) result.snap = tolerance(d, dice);
  if (dice.one_in(6)) result.simplify = tolerance(d, dice);
  if (dice.one_in(6)) result.doors = Range{d, d * dice.between(2, 8)};
  if (has_anchors) result.anchors = {kAnchors};
  return result;
}

}  // namespace

Trial trial(std::uint64_t seed) {
  Dice dice(seed);
  Strokes all = sound(dice);
  const Rational d = hundredths(1 << dice.pick(7));
  const std::size_t count = all.size();
  const auto share = static_cast<std::size_t>(dice.between(1, 8));
  for (std::size_t i = 0; i < count; ++i) {
    if (dice.one_in(share)) damage(all, i, d, dice);
  }
  move_all(all, dice);
  const bool has_anchors = dice.one_in(8);
  bool is_anchored = false;
  Trial result;
  Source anchor;
  anchor.layer = kAnchors;
  const SourceId plain = result.drawing.add_source({}), fixed = result.drawing.add_source(anchor);
  for (const Stroke& s : all) {
    if (s.a == s.b) continue;
    const bool is_fixed = has_anchors && dice.one_in(4);
    is_anchored = is_anchored || is_fixed;
    result.drawing.add(Segment{s.a, s.b}, is_fixed ? fixed : plain);
  }
  result.options = options(d, is_anchored, dice);
  return result;
}

}  // namespace plumbline::repairs

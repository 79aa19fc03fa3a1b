// Plans in metres, on decimetres or centimetres: a rectangle, split again and again.

#include "repair/walls.hpp"

#include <algorithm>

namespace plumbline::repairs {
namespace {

using campaign::Dice;
using inputs::operator+;
using inputs::operator-;
using inputs::operator*;

constexpr int kHundred = 100;
constexpr int kLeastRoom = 150;  ///< hundredths
constexpr int kMoreBeside = 20;

Rational metres(int hundredths) { return Rational(hundredths) / kHundred; }

class Drawing {
 public:
  explicit Drawing(Dice& dice) : dice_(dice), step_(dice.one_in(3) ? 1 : 10) {
    layout_.is_double = dice.one_in(2);
    if (layout_.is_double) thick_ = 5 * dice.between(2, 8);
  }

  Layout run() {
    const int width = rounded(dice_.between(600, 2000)), height = rounded(dice_.between(500, 1500));
    ring(0, 0, width, height);
    if (thick_ > 0) ring(-thick_, -thick_, width + thick_, height + thick_);
    split(0, 0, width, height, dice_.between(2, 4));
    return layout_;
  }

 private:
  int rounded(int value) const { return value / step_ * step_; }

  void add(int ax, int ay, int bx, int by) {
    layout_.walls.push_back({{metres(ax), metres(ay)}, {metres(bx), metres(by)}});
  }
  void ring(int x, int y, int right, int top) {
    add(x, y, right, y);
    add(right, y, right, top);
    add(right, top, x, top);
    add(x, top, x, y);
  }

  /// From one wall to the opposite one.
  void partition(int ax, int ay, int bx, int by, int dx, int dy) {
    layout_.partitions.push_back(layout_.walls.size());
    add(ax, ay, bx, by);
    if (thick_ > 0) add(ax + dx, ay + dy, bx + dx, by + dy);
  }

  void split(int x, int y, int right, int top, int depth) {
    const int width = right - x, height = top - y, both = 2 * kLeastRoom + thick_;
    const bool can_x = width > both, can_y = height > both;
    if (depth == 0 || (!can_x && !can_y)) {
      if (dice_.one_in(6)) oblique(x, right, y);
      return;
    }
    const int at_x =
        rounded(dice_.between(x + kLeastRoom, std::max(x, right - kLeastRoom - thick_)));
    const int at_y = rounded(dice_.between(y + kLeastRoom, std::max(y, top - kLeastRoom - thick_)));
    if (thick_ == 0 && can_x && can_y && dice_.one_in(4)) {  // four rooms about a crossing
      partition(at_x, y, at_x, top, 0, 0);
      partition(x, at_y, right, at_y, 0, 0);
      split(x, y, at_x, at_y, depth - 2 < 0 ? 0 : depth - 2);
      split(at_x, y, right, at_y, depth - 2 < 0 ? 0 : depth - 2);
      split(x, at_y, at_x, top, 0);
      split(at_x, at_y, right, top, 0);
    } else if (can_x && (!can_y || dice_.one_in(2))) {
      partition(at_x, y, at_x, top, thick_, 0);
      split(x, y, at_x, top, depth - 1);
      split(at_x + thick_, y, right, top, depth - 1);
    } else {
      partition(x, at_y, right, at_y, 0, thick_);
      split(x, y, right, at_y, depth - 1);
      split(x, at_y + thick_, right, top, depth - 1);
    }
  }

  /// Across the lower right corner of a room; the sides of the corner are as 1 to 1, 3 to 4 or so.
  void oblique(int x, int right, int y) {
    if (right - x < kLeastRoom) return;
    const int leg = 5 * dice_.between(12, 25), other = leg * dice_.between(2, 5) / 5;
    add(right - leg, y, right, y + other);
  }

  Dice& dice_;
  int step_;
  int thick_ = 0;
  Layout layout_;
};

/// Where walls end on or cross the inside of a wall that is parallel to an axis, from 0 to its
/// length, with both ends.
std::vector<Rational> meetings(const std::vector<Wall>& walls, const Wall& wall) {
  const bool upright = wall.a.x == wall.b.x;
  const auto along = [&](const Point& p) -> Rational {
    return upright ? p.y - wall.a.y : p.x - wall.a.x;
  };
  const auto off = [&](const Point& p) -> Rational {
    return upright ? p.x - wall.a.x : p.y - wall.a.y;
  };
  std::vector<Rational> result = {0, along(wall.b)};
  for (const Wall& other : walls) {
    const Rational p = off(other.a), q = off(other.b);
    if (sgn(p) * sgn(q) > 0) continue;
    if (p == q) {  // along the same line
      for (const Point& end : {other.a, other.b}) result.push_back(along(end));
      continue;
    }
    result.push_back(along(other.a) + p / (p - q) * (along(other.b) - along(other.a)));
  }
  std::erase_if(result, [&](const Rational& r) { return sgn(r) < 0 || r > along(wall.b); });
  std::ranges::sort(result, [](const auto& r, const auto& s) { return cmp(r, s) < 0; });
  return result;
}

}  // namespace

Layout drawn_layout(Dice& dice) { return Drawing(dice).run(); }

std::vector<Wall> with_doors(const Layout& layout, std::vector<Wall>& open, int percent, int beside,
                             Dice& dice) {
  std::vector<Wall> closed = layout.walls;
  bool is_first = true;
  for (const std::size_t i : layout.partitions) {
    if (!is_first && dice.pick(kHundred) >= percent) continue;
    const Wall wall = layout.walls[i];
    std::vector<Rational> free = meetings(layout.walls, wall);
    if (layout.is_double) {
      const std::vector<Rational> more = meetings(layout.walls, layout.walls[i + 1]);
      free.insert(free.end(), more.begin(), more.end());
      std::ranges::sort(free, [](const auto& r, const auto& s) { return cmp(r, s) < 0; });
    }
    const int width = 5 * dice.between(11, 22);
    Rational from = -1;
    for (std::size_t k = 1; k < free.size(); ++k) {
      if (free[k] - free[k - 1] < metres(width + 2 * beside + kMoreBeside)) continue;
      from = free[k - 1] + metres(beside + dice.pick(kMoreBeside));
    }
    if (sgn(from) < 0) continue;
    is_first = false;
    const Point along = wall.a.x == wall.b.x ? Point{0, 1} : Point{1, 0};
    const Point p = wall.a + from * along, q = p + metres(width) * along;
    open[i].b = p;
    open.push_back({q, wall.b});
    if (!layout.is_double) continue;
    const Point across = layout.walls[i + 1].a - wall.a;
    open[i + 1].b = p + across;
    open.push_back({q + across, wall.b + across});
    for (const Point& jamb : {p, q}) {
      open.push_back({jamb, jamb + across});
      closed.push_back({jamb, jamb + across});
    }
  }
  return closed;
}

}  // namespace plumbline::repairs

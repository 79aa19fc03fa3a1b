#include "repair/plans.hpp"

#include <algorithm>
#include <numeric>

#include "plumbline/arrange.hpp"
#include "repair/walls.hpp"

namespace plumbline::repairs {
namespace {

using inputs::operator+;
using inputs::operator-;
using inputs::operator*;

constexpr int kParts = 32;  ///< of the size, of which damages are multiples

/// A length just above that of a vector, with three decimals.
Rational length_above(const Point& v) {
  const double length = nearest_sqrt(v.x * v.x + v.y * v.y);
  if (sgn(v.x) == 0 || sgn(v.y) == 0) return std::max(Rational(abs(v.x)), Rational(abs(v.y)));
  return Rational(static_cast<long>(length * 1000) + 1) / 1000;
}

class Damaging {
 public:
  Damaging(std::vector<Wall> walls, const Rational& size, Dice& dice)
      : walls_(std::move(walls)), size_(size), dice_(dice) {}

  std::vector<Wall>& walls() { return walls_; }

  void apply(Damage damage, std::size_t i) {
    switch (damage) {
      case Damage::Short:
        return move_along(i, -1);
      case Damage::Long:
        return move_along(i, 1);
      case Damage::ShortOrLong:
        return move_along(i, dice_.one_in(2) ? 1 : -1);
      case Damage::Doubled:
        return copy_beside(i);
      case Damage::Moved:
        for (Point* p : {&walls_[i].a, &walls_[i].b}) *p = *p + Point{about_zero(), about_zero()};
        return;
      case Damage::Gaps:
        return cut(i);
      default: {
        constexpr Damage kEach[] = {Damage::Short, Damage::Long, Damage::Doubled, Damage::Moved,
                                    Damage::Gaps};
        return apply(kEach[dice_.pick(std::size(kEach))], i);
      }
    }
  }

 private:
  Rational amount() { return size_ * dice_.between(1, kParts - 1) / kParts; }
  Rational about_zero() { return size_ * dice_.between(1 - kParts / 2, kParts / 2 - 1) / kParts; }
  Point unit(std::size_t i) const {
    const Point along = walls_[i].b - walls_[i].a;
    return Rational(1 / length_above(along)) * along;
  }

  /// One end, or both.
  void move_along(std::size_t i, int sign) {
    const Point u = Rational(sign) * unit(i);
    const int which = dice_.pick(3);
    if (which != 1) walls_[i].a = walls_[i].a - amount() * u;
    if (which != 0) walls_[i].b = walls_[i].b + amount() * u;
  }

  void copy_beside(std::size_t i) {
    const Point u = unit(i), along = walls_[i].b - walls_[i].a;
    Point across{-u.y, u.x};
    if (dice_.one_in(2)) across = Rational(-1) * across;
    Wall copy = walls_[i];
    if (!dice_.one_in(3)) {
      const Rational from = Rational(dice_.between(0, 10)) / 20,
                     to = Rational(dice_.between(14, 20)) / 20;
      copy = {walls_[i].a + from * along, walls_[i].a + to * along};
    }
    const Point aside = amount() * across;
    walls_.push_back({copy.a + aside, copy.b + aside});
  }

  /// A piece of the wall is missing.
  void cut(std::size_t i) {
    const Point along = walls_[i].b - walls_[i].a;
    Wall rest = walls_[i];
    rest.a = walls_[i].a + Rational(dice_.between(2, 18)) / 20 * along;
    walls_[i].b = rest.a - amount() * unit(i);
    if (dice_.one_in(2)) std::swap(rest.a, rest.b);
    walls_.push_back(rest);
  }

  std::vector<Wall> walls_;
  Rational size_;
  Dice& dice_;
};

SegmentSet drawing_of(const std::vector<Wall>& walls, bool is_turned) {
  SegmentSet result;
  const SourceId source = result.add_source({});
  const auto map = [&](const Point& p) {
    return is_turned ? Point{(3 * p.x - 4 * p.y) / 5, (4 * p.x + 3 * p.y) / 5} : p;
  };
  for (const Wall& wall : walls) result.add(Segment{map(wall.a), map(wall.b)}, source);
  return result;
}

/// The least distance of features, rounded down to three decimals.
Rational detail_of(const SegmentSet& drawing) {
  const FeatureSize features = feature_size(arrange(drawing));
  Rational least = features.squared_vertex_vertex;
  if (sgn(features.squared_vertex_edge) > 0) least = std::min(least, features.squared_vertex_edge);
  return Rational(std::max(1L, static_cast<long>(nearest_sqrt(least) * 1000))) / 1000;
}

}  // namespace

std::string to_text(Damage damage) {
  constexpr const char* kNames[] = {
      "ends short",     "ends long", "ends short or long", "walls doubled", "ends moved",
      "pieces missing", "doors",     "doors by corners",   "all but doors", "all"};
  return kNames[static_cast<std::size_t>(damage)];
}

bool has_doors(Damage damage) {
  return damage == Damage::Doors || damage == Damage::DoorsByCorners || damage == Damage::All;
}

bool has_size(Damage damage) { return damage != Damage::Doors && damage != Damage::DoorsByCorners; }

Range door_widths() { return {Rational(1, 2), Rational(6, 5)}; }

Plan plan(Damage damage, const Rational& ratio, std::uint64_t seed) {
  Dice dice(seed);
  Layout layout = drawn_layout(dice);
  const bool is_turned = dice.one_in(2);
  constexpr std::size_t kPercent[] = {1, 5, 10, 20, 50};
  const std::size_t share = kPercent[dice.pick(std::size(kPercent))];
  Plan result;
  result.detail = detail_of(drawing_of(layout.walls, is_turned));
  result.size = result.detail * ratio;
  std::vector<Wall> open = layout.walls;
  if (has_doors(damage)) {
    const int beside = damage == Damage::DoorsByCorners ? 20 : 50;
    layout.walls = with_doors(layout, open, static_cast<int>(share), beside, dice);
  }
  result.right = drawing_of(layout.walls, is_turned);
  Damaging damaging(std::move(open), result.size, dice);
  if (has_size(damage)) {
    std::vector<std::size_t> left(damaging.walls().size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    const std::size_t chosen = std::max<std::size_t>(1, left.size() * share / 100);
    for (std::size_t k = 0; k < chosen; ++k) {
      std::swap(left[k], left[k + static_cast<std::size_t>(dice.pick(left.size() - k))]);
      damaging.apply(damage, left[k]);
    }
  }
  std::erase_if(damaging.walls(), [](const Wall& wall) { return wall.a == wall.b; });
  result.damaged = drawing_of(damaging.walls(), is_turned);
  return result;
}

}  // namespace plumbline::repairs

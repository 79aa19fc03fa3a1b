#include "inputs/workloads.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "plumbline/read.hpp"
#include "plumbline/structure.hpp"

namespace plumbline::inputs {
namespace {

/// splitmix64 (Steele, Lea, Flood: "Fast splittable pseudorandom number generators", 2014): the
/// same numbers with every compiler and library, as std::uniform_*_distribution has not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// Uniform in [0, 1).
  double real() { return static_cast<double>(next() >> 11U) * 0x1p-53; }
  /// Uniform in 0 ... n - 1.
  std::int64_t below(std::uint64_t n) {
    __extension__ using Wide = unsigned __int128;
    return static_cast<std::int64_t>(static_cast<std::uint64_t>((Wide(next()) * n) >> 64U));
  }

 private:
  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
  }

  std::uint64_t state_;
};

struct Lattice {
  std::int64_t x, y;
};

/// A SegmentSet from integers of a unit 1 / per_unit.
class LatticeBuilder {
 public:
  explicit LatticeBuilder(long per_unit) : per_unit_(per_unit), source_(set_.add_source({})) {}

  /// Whether the segment has a length, and so was added.
  bool add(Lattice a, Lattice b) {
    if (a.x == b.x && a.y == b.y) return false;
    set_.add({point(a), point(b)}, source_);
    return true;
  }
  void add(Segment s) { set_.add(std::move(s), source_); }
  /// The integers next to coordinates given in units of 1.
  Lattice rounded(double x, double y) const {
    const auto scale = static_cast<double>(per_unit_);
    return {std::llround(x * scale), std::llround(y * scale)};
  }
  std::size_t size() const { return set_.segments.size(); }
  SegmentSet take() { return std::move(set_); }

 private:
  Point point(Lattice p) const {
    Point q{Rational(p.x, per_unit_), Rational(p.y, per_unit_)};
    q.x.canonicalize();
    q.y.canonicalize();
    return q;
  }

  long per_unit_;
  SegmentSet set_;
  SourceId source_;
};

/// A SegmentSet from doubles, as the decimals of 17 digits that stand for them in files.
class DoubleBuilder {
 public:
  DoubleBuilder() : source_(set_.add_source({})) {}
  void add(const PointD& a, const PointD& b) { set_.add(point(a), point(b), source_); }
  SegmentSet take() { return std::move(set_); }

 private:
  static Number number(double v) { return parse_number(fmt::format("{:.17g}", v)); }
  static NumberPoint point(const PointD& p) { return {number(p.x), number(p.y)}; }

  SegmentSet set_;
  SourceId source_;
};

constexpr long kMicro = 1'000'000, kMilli = 1000;
/// Distance of grid lines and of stars.
constexpr int kPitch = 1000;
constexpr double kPi = std::numbers::pi;

SegmentSet grid_turned_by(double angle, std::uint64_t m) {
  const double side = kPitch * static_cast<double>(m), c = side / 2;
  LatticeBuilder builder(kMilli);
  const auto turned = [&](double x, double y) {
    return builder.rounded(c + (x - c) * std::cos(angle) - (y - c) * std::sin(angle),
                           c + (x - c) * std::sin(angle) + (y - c) * std::cos(angle));
  };
  for (std::uint64_t i = 0; i < m; ++i) {
    const double at = kPitch * static_cast<double>(i) + kPitch / 2.0;
    builder.add(turned(at, 0), turned(at, side));
    builder.add(turned(0, at), turned(side, at));
  }
  return builder.take();
}

/// One of the eight directions in which lattice_segments run; `steps` is changed where a step is
/// longer.
Lattice lattice_direction(std::int64_t percent, Random& random, std::int64_t& steps) {
  if (percent < 35) return {1, 0};
  if (percent < 65) return {0, 1};
  if (percent < 85) {
    const std::int64_t signs = random.below(4);
    return {2 * (signs % 2) - 1, 2 * (signs / 2) - 1};
  }
  static constexpr Lattice kKnight[] = {{1, 2},  {2, 1},  {1, -2},  {2, -1},
                                        {-1, 2}, {-2, 1}, {-1, -2}, {-2, -1}};
  const Lattice direction = kKnight[random.below(std::size(kKnight))];
  steps = 1 + steps / 3;
  return direction;
}

}  // namespace

SegmentSet random_segments(std::uint64_t n) {
  Random random(1000 + n);
  LatticeBuilder builder(kMicro);
  const double length = std::sqrt(kPi / static_cast<double>(n));
  while (builder.size() < n) {
    const double x = length / 2 + (1 - length) * random.real();
    const double y = length / 2 + (1 - length) * random.real();
    const double angle = kPi * random.real();
    const double dx = length / 2 * std::cos(angle), dy = length / 2 * std::sin(angle);
    builder.add(builder.rounded(x - dx, y - dy), builder.rounded(x + dx, y + dy));
  }
  return builder.take();
}

SegmentSet random_lines(std::uint64_t n) {
  // 0.521405 is the mean distance of two random points of the unit square.
  const double scale = n == 5000 ? 0.1 : std::sqrt(8 * kPi / static_cast<double>(n)) / 0.521405;
  Random random(5000 + n);
  LatticeBuilder builder(kMicro);
  while (builder.size() < n) {
    const double px = random.real(), py = random.real();
    const double qx = random.real(), qy = random.real();
    const double cx = random.real(), cy = random.real();
    const double dx = (px - qx) / 2 * scale, dy = (py - qy) / 2 * scale;
    builder.add(builder.rounded(cx + dx, cy + dy), builder.rounded(cx - dx, cy - dy));
  }
  return builder.take();
}

SegmentSet grid(std::uint64_t m) { return grid_turned_by(0, m); }

SegmentSet turned_grid(std::uint64_t m) { return grid_turned_by(0.7, m); }

SegmentSet lattice_segments(std::uint64_t n) {
  const auto side = static_cast<std::uint64_t>(2 * std::sqrt(static_cast<double>(n)));
  Random random(77 + n);
  std::vector<std::pair<Lattice, Lattice>> all;
  while (all.size() < n) {
    const std::int64_t percent = random.below(100);
    if (percent < 5 && !all.empty()) {  // a copy
      auto [a, b] = all[random.below(all.size())];
      if (random.below(2) != 0) std::swap(a, b);
      all.emplace_back(a, b);
      continue;
    }
    Lattice start{};
    start.x = random.below(side);
    start.y = random.below(side);
    if (random.below(5) == 0 && !all.empty()) {  // from the end of another
      const auto& [a, b] = all[random.below(all.size())];
      start = random.below(2) != 0 ? b : a;
    }
    std::int64_t steps = 1 + random.below(20);
    const Lattice step = lattice_direction(percent, random, steps);
    all.push_back({start, {start.x + steps * step.x, start.y + steps * step.y}});
  }
  LatticeBuilder builder(1);
  for (const auto& [a, b] : all) builder.add(a, b);
  return builder.take();
}

SegmentSet stars(std::uint64_t n) {
  constexpr std::uint64_t kLines = 100, kJitter = 100;
  constexpr std::int64_t kReach = 200;
  const std::uint64_t count = n / kLines;
  const auto columns = static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  Random random(33 + n);
  LatticeBuilder builder(1);
  for (std::uint64_t star = 0; star < count; ++star) {
    Lattice c{};
    c.x = static_cast<std::int64_t>(kPitch * (star % columns)) + random.below(kJitter);
    c.y = static_cast<std::int64_t>(kPitch * (star / columns)) + random.below(kJitter);
    while (builder.size() < kLines * (star + 1)) {
      const std::int64_t dx = random.below(2 * kReach + 1) - kReach;
      const std::int64_t dy = random.below(2 * kReach + 1) - kReach;
      if (star % 2 == 0) {
        if (dx == 0 && dy == 0) continue;
        const std::int64_t p = 1 + random.below(3), q = 1 + random.below(3);
        builder.add({c.x - p * dx, c.y - p * dy}, {c.x + q * dx, c.y + q * dy});
      } else {  // through (c.x + 1/3, c.y + 2/3)
        const Lattice u{c.x + dx, c.y + dy};
        builder.add(u, {3 * c.x + 1 - 2 * u.x, 3 * c.y + 2 - 2 * u.y});
      }
    }
  }
  return builder.take();
}

SegmentSet pencil(std::uint64_t n) {
  constexpr std::int64_t kReach = 1'000'000;
  Random random(99 + n);
  LatticeBuilder builder(1);
  while (builder.size() < n) {
    Lattice u{};
    u.x = random.below(2 * kReach + 1) - kReach;
    u.y = random.below(2 * kReach + 1) - kReach;
    builder.add(u, {1 - 2 * u.x, 2 - 2 * u.y});
  }
  return builder.take();
}

SegmentSet double_segments(std::uint64_t n) {
  Random random(1000 + n);
  DoubleBuilder builder;
  const double length = std::sqrt(kPi / static_cast<double>(n));
  for (std::uint64_t i = 0; i < n; ++i) {
    const double x = length / 2 + (1 - length) * random.real();
    const double y = length / 2 + (1 - length) * random.real();
    const double angle = kPi * random.real();
    const double dx = length / 2 * std::cos(angle), dy = length / 2 * std::sin(angle);
    builder.add({x - dx, y - dy}, {x + dx, y + dy});
  }
  return builder.take();
}

SegmentSet turned_rooms(std::uint64_t m) {
  constexpr double kWidth = 5, kHeight = 4, kAngle = 0.3;
  const double c = std::cos(kAngle), s = std::sin(kAngle);
  const auto corner = [&](std::uint64_t i, std::uint64_t j) {
    const double x = kWidth * static_cast<double>(i), y = kHeight * static_cast<double>(j);
    return PointD{c * x - s * y, s * x + c * y};
  };
  DoubleBuilder builder;
  for (std::uint64_t i = 0; i < m; ++i) {
    for (std::uint64_t j = 0; j < m; ++j) {
      builder.add(corner(i, j), corner(i + 1, j));
      builder.add(corner(i + 1, j), corner(i + 1, j + 1));
      builder.add(corner(i + 1, j + 1), corner(i, j + 1));
      builder.add(corner(i, j + 1), corner(i, j));
    }
  }
  return builder.take();
}

SegmentSet rational_copies(std::uint64_t n) {
  constexpr int kRooms = 20, kReach = 200, kTangent = 10'000'000;
  Random random(55 + n);
  LatticeBuilder builder(1);
  for (std::uint64_t copy = 0; copy < n / (2 * kRooms * kRooms); ++copy) {
    const Rational t = Rational(1 + random.below(kTangent)) / (1 + random.below(kTangent));
    const Rational c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
    const Rational x = random.below(kReach), y = random.below(kReach);
    const auto at = [&](int i, int j) {
      return Point{Rational(c * i - s * j + x), Rational(s * i + c * j + y)};
    };
    for (int i = 0; i < kRooms; ++i) {
      for (int j = 0; j < kRooms; ++j) {
        builder.add({at(i, j), at(i + 1, j)});
        builder.add({at(i, j), at(i, j + 1)});
      }
    }
  }
  return builder.take();
}

SegmentSet tiny_pieces(std::uint64_t n) {
  constexpr double kSide = 10'000, kHalf = 0.25;
  Random random(66 + n);
  LatticeBuilder builder(kMicro);
  while (builder.size() < n) {
    const double x = kSide * random.real(), y = kSide * random.real(), angle = kPi * random.real();
    const double dx = kHalf * std::cos(angle), dy = kHalf * std::sin(angle);
    builder.add(builder.rounded(x - dx, y - dy), builder.rounded(x + dx, y + dy));
  }
  return builder.take();
}

SegmentSet streets(std::uint64_t n) {
  constexpr std::uint64_t kEdges = 50;
  constexpr double kLength = 0.01, kTurn = 0.6;
  const double side = kLength * std::sqrt(static_cast<double>(n)) * 4;
  Random random(88 + n);
  LatticeBuilder builder(10 * kMicro);
  for (std::uint64_t street = 0; street < n / kEdges; ++street) {
    double x = side * random.real(), y = side * random.real(), angle = 2 * kPi * random.real();
    for (std::uint64_t edge = 0; edge < kEdges; ++edge) {
      angle += kTurn * (random.real() - 0.5);
      const double nx = x + kLength * std::cos(angle), ny = y + kLength * std::sin(angle);
      builder.add(builder.rounded(x, y), builder.rounded(nx, ny));
      x = nx;
      y = ny;
    }
  }
  return builder.take();
}

SegmentSet double_walls(std::uint64_t m) {
  // In thousandths: the sides of a room, half a wall, a door, and what it is open by.
  constexpr std::int64_t kWidth = 5250, kHeight = 4200, kHalf = 125, kDoor = 900;
  constexpr Lattice kOpen{450, 779};
  Random random(44 + m);
  LatticeBuilder builder(kMilli);
  for (std::uint64_t i = 0; i < m; ++i) {
    for (std::uint64_t j = 0; j < m; ++j) {
      const std::int64_t x = kWidth * static_cast<std::int64_t>(i);
      const std::int64_t y = kHeight * static_cast<std::int64_t>(j);
      const std::int64_t low_x = x - kHalf, high_x = x + kWidth + kHalf;
      const std::int64_t low_y = y - kHalf, high_y = y + kHeight + kHalf;
      for (const std::int64_t side : {-kHalf, kHalf}) {
        builder.add({x + side, low_y}, {x + side, high_y});
        builder.add({x + kWidth + side, low_y}, {x + kWidth + side, high_y});
        builder.add({low_x, y + side}, {high_x, y + side});
        builder.add({low_x, y + kHeight + side}, {high_x, y + kHeight + side});
      }
      const std::int64_t door = x + kDoor + random.below(kWidth - 3 * kDoor);
      builder.add({door, y - kHalf}, {door, y + kHalf});
      builder.add({door + kDoor, y - kHalf}, {door + kDoor, y + kHalf});
      builder.add({door, y + kHalf}, {door + kOpen.x, y + kHalf + kOpen.y});
    }
  }
  return builder.take();
}

SegmentSet tiles(const SegmentSet& drawing, std::uint64_t count, int dx, int dy) {
  LatticeBuilder builder(1);
  for (std::uint64_t tile = 0; tile < count; ++tile) {
    const Rational x = Rational(tile) * dx, y = Rational(tile) * dy;
    for (const auto& [a, b] : drawing.segments) {
      builder.add({{a.x + x, a.y + y}, {b.x + x, b.y + y}});
    }
  }
  return builder.take();
}

SegmentSet hospital(const std::filesystem::path& directory) {
  LatticeBuilder builder(1);
  for (const char* name : kHospitalFiles) {
    const SegmentSet drawing = evaluate(read(directory / (std::string(name) + ".svg")));
    for (const Segment& s : drawing.segments) builder.add(s);
  }
  return builder.take();
}

}  // namespace plumbline::inputs

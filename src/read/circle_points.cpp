#include "read/circle_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

using Integers = CircleQuarter::Integers;

/// Sums of two squares: 5 = 2^2 + 1^2, 13, 17, 5 again, ... The product of all is below 2^59.
constexpr std::array<Integers, 12> kSquares{{{2, 1},
                                             {3, 2},
                                             {4, 1},
                                             {2, 1},
                                             {5, 2},
                                             {6, 1},
                                             {5, 4},
                                             {7, 2},
                                             {6, 5},
                                             {8, 3},
                                             {8, 5},
                                             {9, 4}}};

Integers product(const Integers& z, const Integers& w) {
  return {z.x * w.x - z.y * w.y, z.x * w.y + z.y * w.x};
}

Integers mirrored(const Integers& z) { return {z.y, z.x}; }

/// The image of z in the eighth from (1, 0) to the diagonal.
Integers in_eighth(const Integers& z) {
  const std::int64_t x = std::abs(z.x);
  const std::int64_t y = std::abs(z.y);
  return {std::max(x, y), std::min(x, y)};
}

/// Rounded: a relative error below 1e-15.
double distance(const Integers& z, const Integers& w, std::int64_t denominator) {
  return std::hypot(static_cast<double>(z.x - w.x), static_cast<double>(z.y - w.y)) /
         static_cast<double>(denominator);
}

double longest_chord(const std::vector<Integers>& eighth, std::int64_t denominator) {
  double longest = distance(eighth.back(), mirrored(eighth.back()), denominator);
  for (std::size_t i = 1; i < eighth.size(); ++i) {
    longest = std::max(longest, distance(eighth[i - 1], eighth[i], denominator));
  }
  return longest;
}

}  // namespace

CirclePoints::CirclePoints() : levels_{{1, {{1, 0}}, std::sqrt(2.0)}} {}

void CirclePoints::add_level() {
  ensure(levels_.size() <= kSquares.size(), "a shorter chord of a circle than stated");
  const Level& last = levels_.back();
  const auto [a, b] = kSquares[levels_.size() - 1];
  const std::int64_t p = a * a + b * b;
  const Integers turn{a * a - b * b, 2 * a * b};
  Level next{last.denominator * p, {}, 0};
  for (const Integers& z : last.eighth) {
    next.eighth.push_back({z.x * p, z.y * p});
    next.eighth.push_back(in_eighth(product(z, turn)));
    next.eighth.push_back(in_eighth(product(z, {turn.x, -turn.y})));
  }
  const auto less = [](const Integers& z, const Integers& w) { return z.y < w.y; };
  const auto equal = [](const Integers& z, const Integers& w) { return z.y == w.y; };
  std::sort(next.eighth.begin(), next.eighth.end(), less);
  next.eighth.erase(std::unique(next.eighth.begin(), next.eighth.end(), equal), next.eighth.end());
  next.longest_chord = longest_chord(next.eighth, next.denominator);
  levels_.push_back(std::move(next));
}

CircleQuarter CirclePoints::quarter(double longest) {
  constexpr double kSafe = 1 - 1e-12;  // outweighs the rounding of `distance`
  longest *= kSafe;
  std::size_t l = 0;
  while (levels_[l].longest_chord > longest) {
    if (++l == levels_.size()) add_level();
  }
  const auto& [denominator, eighth, unused] = levels_[l];
  CircleQuarter result{denominator, {eighth.front()}};
  // As few of them as will do: from each to the farthest that is near enough.
  std::size_t i = 0;
  while (distance(eighth[i], mirrored(eighth[i]), denominator) > longest) {
    std::size_t next = i + 1;
    while (next + 1 < eighth.size() &&
           distance(eighth[i], eighth[next + 1], denominator) <= longest) {
      ++next;
    }
    i = next;
    result.points.push_back(eighth[i]);
  }
  for (std::size_t k = result.points.size(); k-- > 1;) {
    result.points.push_back(mirrored(result.points[k]));
  }
  return result;
}

}  // namespace plumbline

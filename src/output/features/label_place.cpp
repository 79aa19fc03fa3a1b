#include "output/features/label_place.hpp"

#include <algorithm>

namespace plumbline::features {
namespace {

using Rings = std::vector<std::vector<PointD>>;

/// Where the boundary crosses the line of points whose coordinate `c` is `at`, by their other
/// coordinates `d`, ascending.
std::vector<double> crossings(const Rings& rings, double PointD::*c, double PointD::*d, double at) {
  std::vector<double> result;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PointD& p = ring[i];
      const PointD& q = ring[i + 1 < ring.size() ? i + 1 : 0];
      if ((p.*c <= at) == (q.*c <= at)) continue;
      result.push_back(p.*d + (q.*d - p.*d) * ((at - p.*c) / (q.*c - p.*c)));
    }
  }
  std::ranges::sort(result);
  return result;
}

struct Piece {
  double middle = 0, length = 0;
};

Piece widest(const std::vector<double>& ends) {
  Piece best;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    const double length = ends[i + 1] - ends[i];
    if (length > best.length) best = {ends[i] + length / 2, length};
  }
  return best;
}

/// The piece around a place; one without length where it is in none.
Piece around(const std::vector<double>& ends, double place) {
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    if (ends[i] < place && place < ends[i + 1]) {
      return {ends[i] + (ends[i + 1] - ends[i]) / 2, ends[i + 1] - ends[i]};
    }
  }
  return {};
}

}  // namespace

LabelPlace label_place(const Rings& rings) {
  constexpr int kLines = 15;
  constexpr double kShape = 3;  // of a text, its width by its height
  const auto [low, high] =
      std::ranges::minmax(rings.at(0), {}, [](const PointD& p) { return p.y; });
  LabelPlace best{low};
  for (int i = 0; i < kLines; ++i) {
    const double y = low.y + (high.y - low.y) * ((i + 0.5) / kLines);
    const Piece across = widest(crossings(rings, &PointD::y, &PointD::x, y));
    const Piece upright = around(crossings(rings, &PointD::x, &PointD::y, across.middle), y);
    if (upright.length == 0) continue;
    const Piece room =
        around(crossings(rings, &PointD::y, &PointD::x, upright.middle), across.middle);
    if (std::min(room.length, kShape * upright.length) >
        std::min(best.width, kShape * best.height)) {
      best = {{across.middle, upright.middle}, room.length, upright.length};
    }
  }
  return best;
}

}  // namespace plumbline::features

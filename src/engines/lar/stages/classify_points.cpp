// Point in polygon by tile codes: the plane around a point is cut into nine tiles by the vertical
// and the horizontal through it; the tiles of an edge's ends tell mostly whether it crosses the
// half-line to the right. Repaired: a vertex on the half-line gives two half crossings, one per
// edge; two of them make a crossing if one comes from above and one from below, so counting those
// from below alone gives the right parity, in whatever order they come.

#include <algorithm>
#include <numeric>

#include "engines/lar/stages/tile_code.hpp"
#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {
namespace {

/// How the edge from p to q meets the half-line to the right of the point `from`.
Crossing cross_half_line(const PointD& from, const PointD& p, const PointD& q) {
  const unsigned c1 = tile_code(from, p), c2 = tile_code(from, q);
  const unsigned both = c1 & c2, either = c1 | c2;
  if (c1 == kHere || c2 == kHere) return Crossing::OnPoint;
  if (both & (kAbove | kBelow | kLeft)) return Crossing::None;
  if (!(either & (kAbove | kBelow))) return both & kRight ? Crossing::None : Crossing::OnPoint;
  if (c1 == kRight || c2 == kRight) return either & kBelow ? Crossing::Odd : Crossing::None;
  if (c1 == kLeft || c2 == kLeft) return Crossing::None;
  if (!(either & kLeft)) {
    return either & kRight ? Crossing::Odd : Crossing::OnPoint;
  }
  if (!(either & kRight)) return Crossing::None;
  const double x = (from.y - q.y) * (p.x - q.x) / (p.y - q.y) + q.x;
  return x > from.x ? Crossing::Odd : x < from.x ? Crossing::None : Crossing::OnPoint;
}

}  // namespace

std::vector<Position> classify_points(std::span<const PointD> polygon,
                                      std::span<const PointD> points) {
  std::vector<std::size_t> by_height(points.size());
  std::iota(by_height.begin(), by_height.end(), std::size_t{0});
  std::sort(by_height.begin(), by_height.end(),
            [&](std::size_t i, std::size_t j) { return points[i].y < points[j].y; });
  std::vector<Position> result(points.size(), Position::Out);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PointD& p = polygon[i];
    const PointD& q = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const auto [low, high] = std::minmax(p.y, q.y);
    auto at = std::lower_bound(by_height.begin(), by_height.end(), low,
                               [&](std::size_t k, double y) { return points[k].y < y; });
    for (; at != by_height.end() && points[*at].y <= high; ++at) {
      Position& position = result[*at];
      const Crossing crossing = cross_half_line(points[*at], p, q);
      if (crossing == Crossing::OnPoint) position = Position::On;
      if (crossing == Crossing::None || position == Position::On) continue;
      position = position == Position::In ? Position::Out : Position::In;
    }
  }
  return result;
}

}  // namespace plumbline::lar

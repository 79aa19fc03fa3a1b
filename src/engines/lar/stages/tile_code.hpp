#pragma once

#include "plumbline/geometry.hpp"

namespace plumbline::lar {

/// The plane around a point is cut into nine tiles by the vertical and the horizontal through it
/// (inters, 2.10): bits that tell where another point lies.
enum Tile : unsigned { kHere = 0, kAbove = 1, kBelow = 2, kRight = 4, kLeft = 8 };

inline unsigned tile_code(const PointD& around, const PointD& p) {
  return (p.y > around.y ? kAbove : kHere) | (p.y < around.y ? kBelow : kHere) |
         (p.x > around.x ? kRight : kHere) | (p.x < around.x ? kLeft : kHere);
}

/// What one edge does to the count of crossings of the half-line to the right.
enum class Crossing { None, Odd, OnPoint };

}  // namespace plumbline::lar

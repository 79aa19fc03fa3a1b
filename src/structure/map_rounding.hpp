#pragma once

#include <numbers>

#include "plumbline/structure.hpp"

namespace plumbline {

/// In the last place of a double, of its size.
inline constexpr double kUnit = 0x1p-52;

/// How far points under a map may lie from where they were meant to be: by their own texts
/// (`text_rounding`) times the map's stretch, and by the map's numbers, which doubles or replaced
/// angles gave.
class MapRounding {
 public:
  /// `angle` bounds the deviation of angles. Requires: a map of the plane.
  MapRounding(const Affine& map, double angle);

  double of(const Number& x, const Number& y) const;
  /// No point of the plane is moved further from another one by the map than so many times.
  double stretch() const { return stretch_; }
  /// How much larger the map makes lengths; of one that is no similarity, on average.
  double scale() const { return stretch_ / std::numbers::sqrt2; }

 private:
  double stretch_ = 0;
  double of_turn_ = 0;   ///< of a point at distance 1, before the stretch
  double of_shift_ = 0;  ///< of every point
};

/// The largest deviation of angles: what the ledger has, and of turns that are still to be
/// replaced; in radians, 0 where there are none.
double largest_angle(const Structure& structure);

}  // namespace plumbline

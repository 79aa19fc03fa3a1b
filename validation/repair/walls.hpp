#pragma once

#include <vector>

#include "campaign/dice.hpp"
#include "inputs/draw.hpp"

namespace plumbline::repairs {

struct Wall {
  Point a, b;
};

/// The walls of a plan, parallel to the axes but for oblique ones. Partitions of two lines are
/// two walls, one after the other.
struct Layout {
  std::vector<Wall> walls;
  std::vector<std::size_t> partitions;  ///< walls that may have doors; of two the first
  bool is_double = false;
};

Layout drawn_layout(campaign::Dice& dice);

/// Cuts doors into some per cent of the partitions of `open`, at least into one if there is room;
/// the walls as they are with doors closed. From `beside` hundredths up to 20 more of wall are
/// between a door and a junction.
std::vector<Wall> with_doors(const Layout& layout, std::vector<Wall>& open, int percent, int beside,
                             campaign::Dice& dice);

}  // namespace plumbline::repairs

#pragma once

#include <string>
#include <vector>

#include "campaign/dice.hpp"
#include "plumbline/repair.hpp"

namespace plumbline::repairs {

using campaign::Dice;

/// A small drawing, and how it is to be repaired.
struct Trial {
  SegmentSet drawing;
  RepairOptions options;
};

/// Plans, hatches, combs, stars, chains of collinear pieces, curves of short chords, bundles of
/// near-parallel lines or segments of a lattice, up to some 25 segments; damaged in all ways and
/// sizes; with tolerances from none to the size of the rooms, some of them automatic.
Trial trial(std::uint64_t seed);

}  // namespace plumbline::repairs

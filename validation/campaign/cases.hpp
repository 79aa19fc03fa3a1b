#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/relations.hpp"
#include "inputs/families.hpp"

namespace plumbline::campaign {

/// What a campaign is made of.
struct Plan {
  std::vector<std::string> families;
  std::uint64_t seed = 1;
  bool claims = false;  ///< asks nothing but Relation::Claims
};

/// One input and what it is asked.
struct Case {
  std::size_t family;  ///< index into the plan's
  unsigned seed;       ///< of the input
  inputs::Extent extent;
  Relation relation;
  std::uint64_t dice;  ///< for the relation's choices
};

/// Case number `number` of a plan, by nothing else. Nearly all inputs are small ones, since their
/// oddities come more densely and a second holds more of them, three quarters from cheap families;
/// one in 256 is of usual size, one in 2048 a full place, as far as the plan's families have such.
Case case_of(const Plan& plan, std::uint64_t number);

SegmentSet input_of(const Plan& plan, const Case& one);

}  // namespace plumbline::campaign

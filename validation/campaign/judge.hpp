#pragma once

#include <cstdint>
#include <string>

#include "campaign/relations.hpp"
#include "plumbline/geometry.hpp"

namespace plumbline::campaign {

/// Everything that is expected of the arrangement of any input whatever.
/// The kind of the first expectation that fails, such as "the engines differ" or "mapped: does not
/// hold"; empty if none does. Checks both engines, the invariants, and one relation with the
/// choices that `seed` determines.
std::string what_is_wrong(const SegmentSet& input, Relation relation, std::uint64_t seed);

}  // namespace plumbline::campaign

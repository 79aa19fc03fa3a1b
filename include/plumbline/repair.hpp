#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plumbline/edits.hpp"

namespace plumbline {

/// How to repair. A tolerance that is not given is chosen from the drawing; 0 turns the operation
/// off.
struct RepairOptions {
  std::optional<Rational> weld, grow, trim, sliver;
  Rational snap = 0, simplify = 0;            ///< off unless given
  std::optional<Range> doors = std::nullopt;  ///< off unless given
  std::vector<std::string> walls;    ///< layers whose lines have doors and block them; none: all
  std::vector<std::string> anchors;  ///< layers that no edit touches and to which others go
  std::vector<std::string> except;   ///< ids of elements that no edit touches
};

/// Repairs line work, by the least edits that do it: what moves nothing first, then additions,
/// removals, movements. See docs/repair.md for each operation and what is promised.
Repair repair(const SegmentSet& input, const RepairOptions& options = {});

}  // namespace plumbline

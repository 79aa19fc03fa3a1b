#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/edits.hpp"

namespace plumbline {

/// How to repair. Sizes are in drawing units. One that is not given is chosen from the drawing; 0
/// turns the operation off.
struct RepairOptions {
  std::optional<Rational> weld, grow, trim, sliver;
  Rational snap = 0, simplify = 0;            ///< off unless given
  std::optional<Range> doors = std::nullopt;  ///< widths of openings to close; off unless given
  /// Whether a side that two closed shapes have in common stays drawn by both; else it becomes one
  /// line, as everything that is drawn twice.
  bool keeps_common_sides = true;
  bool keeps_layers = true;          ///< whether what two layers draw stays drawn by both
  std::vector<std::string> walls;    ///< layers whose lines have doors and block them; none: all
  std::vector<std::string> anchors;  ///< layers that no edit touches and to which others go
  std::vector<std::string> except;   ///< ids of elements that no edit touches
  /// Asked before each step, in the calling thread; the work ends with Error Cancelled where it
  /// returns false.
  std::function<bool()> goes_on = {};
};

/// Repairs line work: lines that overlap become one, doubled ones are welded, loose ends run on to
/// what they meet, dangles are trimmed, slivers given to a neighbour, doors closed by virtual
/// lines; the least that does it, and nothing that is not listed. docs/repair.md says what each
/// operation does, what is promised and how tolerances are chosen. **Exact**; `verify` has found
/// the result to keep its promises. Order: edits in the order in which they were made; they depend
/// on the geometry alone, not on order, direction or repetition of the segments. Degenerate: no
/// segments give no edits; isolated points are left as they are. What cannot be done without
/// breaking a promise is in `refused`. Cost: some times that of `arrange`, O(n log n), where
/// tolerances are no larger than the details; for k loose ends within reach of each other up to
/// O(k^2). Throws: Error BadInput for a negative size, an empty range of doors, a layer or an id
/// that the drawing does not have; as `arrange`.
Repair repair(const SegmentSet& input, const RepairOptions& options = {});

}  // namespace plumbline

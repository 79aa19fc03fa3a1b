#pragma once

#include <string>
#include <vector>

#include "campaign/dice.hpp"
#include "plumbline/repair.hpp"

namespace plumbline::repairs {

using campaign::Dice;

/// How walls of a plan are damaged.
enum class Damage {
  Short,
  Long,
  ShortOrLong,
  Doubled,
  Moved,  ///< ends go anywhere within the size
  Gaps,
  Doors,           ///< openings; the walls beside them are as long as the least one
  DoorsByCorners,  ///< they are shorter
  AllButDoors,
  All
};
inline constexpr std::size_t kDamages = 10;
/// Whether there are doors.
bool has_doors(Damage damage);
/// Whether the size has a meaning.
bool has_size(Damage damage);
/// "ends short", ...
std::string to_text(Damage damage);

/// A floor plan, as it should be and as it was drawn.
struct Plan {
  SegmentSet right;    ///< with the lines that close doors
  SegmentSet damaged;  ///< **exact**
  Rational detail;     ///< least distance of a vertex from another one, or from a wall beside it
  Rational size;       ///< damages are smaller than this
};

/// Openings are within this range, in drawing units.
Range door_widths();

/// A rectangle, split into rooms by walls of one line or of two, with junctions of three and four
/// walls and some oblique walls; in half of the plans turned by an angle with cosine 3/5. From one
/// wall to half of them are damaged, by less than `ratio` times the detail.
Plan plan(Damage damage, const Rational& ratio, std::uint64_t seed);

}  // namespace plumbline::repairs

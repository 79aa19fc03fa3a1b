#pragma once

#include <set>

#include "plumbline/repair.hpp"
#include "repair/work.hpp"

/// The steps of `repair`. Each looks at the arrangement of the lines that there are, and
/// makes its edits in an order that the geometry alone decides.
namespace plumbline::repair_steps {

/// The segments on layers of anchors and of excepted elements, ascending. Throws: Error BadInput
/// for a layer or an id that there is not.
std::vector<SegmentId> anchored_segments(const SegmentSet& input, const RepairOptions& options);
/// Lines that share more than a point become one, but for common sides of neighbouring shapes, and
/// lines of different layers, where these are kept.
void merge(Work& work, const Arranged& arranged, bool keeps_common_sides, bool keeps_layers);
/// Lines that hang together on one straight line go onto a stronger such line beside them, with all
/// that meets them. Only what has a line from `first_new` on is looked at: that of the others
/// nothing goes onto another one is known.
void weld(Work& work, const Arranged& arranged, const Rational& distance, LineId first_new,
          const std::set<SegmentId>& stays);
/// How far the lines that would go are from those that they would go onto, squared.
std::vector<Rational> weld_offsets(Work& work, const Arranged& arranged, const Rational& distance);
/// Vertices go to sites further apart than the distance, edges lead over the sites near them.
void snap(Work& work, const Arranged& arranged, const Rational& distance);
/// Vertices between two lines go. To be repeated until nothing changes.
void simplify(Work& work, const Arranged& arranged, const Rational& distance);
/// Loose ends run on, all at the same speed, each until it first meets the drawing or the track of
/// another one that was there before: a bounded motorcycle graph (Eppstein, Erickson 1999).
void grow(Work& work, const Arranged& arranged, const Rational& reach);
/// Loose chains go, those of the smallest reach first.
void trim(Work& work, const Arranged& arranged, const Rational& reach);
/// Two loose ends near each other that face each other on parallel lines are joined.
void join_offset_ends(Work& work, const Arranged& arranged, const Rational& reach);
/// Says which loose ends are still there with something within reach that they do not lead to.
void refuse_open_ends(Work& work, const Arranged& arranged, const Rational& reach);
/// Reaches, squared, of the loose chains that go past a junction which one of their lines crosses,
/// and of the others.
struct LooseReaches {
  std::vector<Rational> past, others;
};
LooseReaches loose_reaches(Work& work, const Arranged& arranged, const Rational& most);
/// Faces no wider than that go to a neighbour: the longest chain of their border that parts them
/// from one goes. To be repeated until nothing changes.
void give_slivers(Work& work, const Arranged& arranged, const Rational& distance);
/// Openings between lines of these layers (patterns; none: of all) that are as wide as a door are
/// closed by virtual lines, where that parts two faces.
void close_doors(Work& work, const Range& doors, const std::vector<std::string>& wall_layers);
/// Where edits since `first_edit` have left two lines end to end on one line, these become one.
void dissolve(Work& work, std::size_t first_edit);

}  // namespace plumbline::repair_steps

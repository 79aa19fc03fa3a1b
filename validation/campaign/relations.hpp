#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "plumbline/complex.hpp"

namespace plumbline::campaign {

/// What is known of the arrangement of a changed input from that of the input: metamorphic
/// relations (Chen, Cheung, Yiu, "Metamorphic testing", 1998).
enum class Relation {
  Permuted,    ///< segments and points in another order
  Reversed,    ///< some segments turned round
  Duplicated,  ///< some segments twice or more, some of these turned round
  Split,       ///< one segment cut in two: a vertex more at most, at the cut
  Mapped,      ///< an affine map of the plane, undone on the result
  TwoCopies,   ///< once more, far away
  Noded,       ///< the edges of the result as input: they are their own arrangement
  Threads,     ///< on two or three threads
  Claims,      ///< what `check` claims of float LAR's answer (claims.hpp); only if asked for
};
inline constexpr std::array kRelations = {
    Relation::Permuted, Relation::Reversed, Relation::Duplicated,
    Relation::Split,    Relation::Mapped,   Relation::TwoCopies,
    Relation::Noded,    Relation::Threads,  Relation::Claims};

std::string to_text(Relation relation);

/// Whether the relation holds between the input and its arrangement, for a choice of segment, map
/// and so on that the seed determines.
bool holds(Relation relation, const SegmentSet& input, const ExactComplex& complex,
           std::uint64_t seed);

}  // namespace plumbline::campaign

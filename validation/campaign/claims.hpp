#pragma once

#include <cstdint>
#include <string>

#include "plumbline/check.hpp"

namespace plumbline::campaign {

/// What `check` claims of float LAR's answer, at a radius that the seed determines, and a run or
/// the definition refutes; empty if nothing is.
///
/// - Advice: the radius in the sentence is run, and the finding is not there; where the least
/// radius
///   is said not to help, it is.
/// - A confirmed cause: with the output of its last stage (of itself and those in `with`) continued
///   exactly, a finding has all the cells; with the input of one of them, none of its kind has one.
/// - Rounding alone: to the doubles themselves the engine does no such thing at the cells that
///   rounding made, unless it changes nothing but what rounding had made wrong, or is to blame for
///   another such finding there.
/// - The drawing's own digits: what is a vertex's is of one place of the drift.
std::string refuted_claim(const SegmentSet& input, const ExactComplex& complex, std::uint64_t seed);
/// The same of a check. Requires: of float LAR, with its own tolerance.
std::string refuted_claim(const Check& check);

}  // namespace plumbline::campaign

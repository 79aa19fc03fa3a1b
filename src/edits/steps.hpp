#pragma once

#include <vector>

#include "edits/replay.hpp"
#include "plumbline/edits.hpp"

// The steps of `verify`, a source of each name. Each returns the breaches that it finds.
namespace plumbline::edits {

/// Whether the parts of a repair fit together: lists, ids, sources; whatever it keeps of the input.
std::vector<Breach> check_form(const SegmentSet& input, const Repair& repair);

/// Each edit by itself: that it does what its kind says, no farther than it says, within the
/// tolerance, to lines that no one has anchored, and accounts for all segments.
std::vector<Breach> check_rules(const SegmentSet& input, const Repair& repair);

/// What an edit's kind says of the lines around it, at its time.
std::vector<Breach> check_surroundings(const SegmentSet& input, const Repair& repair,
                                       const Replay& replay);

/// How far ends of the output lie from the segments that they stand for, all edits together.
std::vector<Breach> check_movement(const SegmentSet& input, const Repair& repair,
                                   const Replay& replay);

/// Lines that were moved meet what they met before, or what ended as near as they moved.
std::vector<Breach> check_meetings(const SegmentSet& input, const Repair& repair,
                                   const ExactComplex& after);

/// What became of faces is what `face_outcomes` finds, each by edits that can do that; virtual
/// lines are between two faces.
std::vector<Breach> check_faces(const ExactComplex& before, const Repair& repair,
                                const ExactComplex& after);

}  // namespace plumbline::edits

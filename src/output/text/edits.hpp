#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plumbline/edits.hpp"

namespace plumbline {

/// All segments of the input that the edit's lines stand for, ascending, each once.
std::vector<SegmentId> segments_of(const Edit& edit);

/// Per edit what it did to rooms: "closed 80, split 40 + 40"; "" where nothing. At most so many
/// faces of each edit.
std::vector<std::string> room_texts(const Repair& repair, std::size_t most);
/// Per edit the area of the faces that it changed.
std::vector<double> effects(const Repair& repair);
/// The edits that change most first: faces by area, then by size.
std::vector<std::size_t> most_effective_first(const Repair& repair);

/// Where an edit is, in digits that suit the size of what happened there.
std::string place_text_of(const Point& where, const Rational& squared_size);
/// "plan.dxf:312 LINE #2F on A-WALL and 2 more"; "a new line" of no segment.
std::string element_text(const SegmentSet& input, const std::vector<SegmentId>& segments);

}  // namespace plumbline

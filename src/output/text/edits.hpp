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

}  // namespace plumbline

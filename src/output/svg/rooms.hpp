#pragma once

#include <string>

#include "plumbline/rooms.hpp"

namespace plumbline {

/// The plan alone, as an SVG element for a page: rooms are paths with the attribute data-room, all
/// in a group "drawing".
std::string plan_of_rooms(const Rooms& rooms, const SegmentSet& input, const ExactComplex& complex);

}  // namespace plumbline

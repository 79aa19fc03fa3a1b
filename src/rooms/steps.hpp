#pragma once

#include <vector>

#include "plumbline/rooms.hpp"

/// The steps of `rooms`, in order; each looks at the result of those before it.
namespace plumbline::rooms_steps {

/// Which faces are rooms, and their sizes.
Rooms wide_faces(const SegmentSet& input, const ExactComplex& complex, const RoomOptions& options);
/// Labels in rooms, and closed elements around them.
void name_rooms(Rooms& rooms, const SegmentSet& input, const ExactComplex& complex);
/// What lies on the other side of their sides, and of narrow faces beside them.
void find_neighbours(Rooms& rooms, const SegmentSet& input, const ExactComplex& complex,
                     const std::vector<std::string>& doors);

/// Per face the room that it is, or kNoRoom.
inline constexpr std::size_t kNoRoom = static_cast<std::size_t>(-1);
std::vector<std::size_t> room_of_face(const Rooms& rooms, const ExactComplex& complex);

}  // namespace plumbline::rooms_steps

#pragma once

#include <vector>

#include "plumbline/polygons.hpp"
#include "plumbline/rooms.hpp"

/// The steps of `rooms`, in order; each looks at the result of those before it.
namespace plumbline::rooms_steps {

/// Which faces are rooms, and their sizes but for gross areas.
Rooms wide_faces(const SegmentSet& input, const ExactComplex& complex, const RoomOptions& options);
/// Per face the innermost one that surrounds it: in a hole of whose polygon it lies, also where
/// both touch in points or an antenna leads from one to the other; else kUnbounded. Requires: the
/// polygons of the complex.
std::vector<FaceId> surrounding_faces(const ExactComplex& complex,
                                      const std::vector<FacePolygon>& shapes);
/// Labels in rooms, and closed elements around them.
void name_rooms(Rooms& rooms, const SegmentSet& input, const ExactComplex& complex,
                const std::vector<FaceId>& surrounding);
/// What lies on the other side of their sides, and of narrow faces beside them.
void find_neighbours(Rooms& rooms, const SegmentSet& input, const ExactComplex& complex,
                     const std::vector<std::string>& doors);

/// Per face the room that it is, or kNoRoom.
inline constexpr std::size_t kNoRoom = static_cast<std::size_t>(-1);
std::vector<std::size_t> room_of_face(const Rooms& rooms, const ExactComplex& complex);
/// The face, if it is a room, else the innermost room that surrounds it, or kNoRoom.
std::size_t room_around(const std::vector<FaceId>& surrounding,
                        const std::vector<std::size_t>& room_of, FaceId face);

}  // namespace plumbline::rooms_steps

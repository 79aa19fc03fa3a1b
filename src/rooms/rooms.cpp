#include "plumbline/rooms.hpp"

#include <algorithm>

#include "plumbline/error.hpp"
#include "rooms/steps.hpp"

namespace plumbline {

Rooms rooms(const SegmentSet& input, const ExactComplex& complex, const RoomOptions& options) {
  for (const auto& size : {options.min_area, options.min_width}) {
    if (size && sgn(*size) < 0) {
      throw Error(ErrorCode::BadInput, "a room's least area and width are not negative", {},
                  exact_text(*size));
    }
  }
  Rooms result = rooms_steps::wide_faces(input, complex, options);
  const std::vector<std::size_t> room_of = rooms_steps::room_of_face(result, complex);
  for (Room& room : result.rooms) {
    FaceId around = complex.parent(room.face);
    while (around != kUnbounded && room_of[around] == rooms_steps::kNoRoom) {
      around = complex.parent(around);
    }
    if (around != kUnbounded) room.parent = room_of[around];
  }
  rooms_steps::name_rooms(result, input, complex);
  rooms_steps::find_neighbours(result, input, complex, options.doors);
  return result;
}

std::vector<std::size_t> room_colours(const Rooms& rooms) {
  std::vector<std::size_t> result;
  for (std::size_t r = 0; r < rooms.rooms.size(); ++r) {
    std::vector<bool> taken;
    const auto take = [&](std::size_t colour) {
      if (colour >= taken.size()) taken.resize(colour + 1);
      taken[colour] = true;
    };
    for (const RoomNeighbour& next : rooms.rooms[r].neighbours) {
      if (next.room < r) take(result[next.room]);
    }
    if (const auto parent = rooms.rooms[r].parent; parent && *parent < r) take(result[*parent]);
    result.push_back(
        static_cast<std::size_t>(std::find(taken.begin(), taken.end(), false) - taken.begin()));
  }
  return result;
}

}  // namespace plumbline

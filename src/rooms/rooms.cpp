#include "plumbline/rooms.hpp"

#include <algorithm>
#include <utility>

#include "plumbline/error.hpp"
#include "rooms/steps.hpp"

namespace plumbline {
namespace {

/// Of a counter-clockwise ring, exactly.
Rational area_within(const ExactComplex& complex, const std::vector<VertexId>& ring) {
  Rational twice;
  Point p = complex.vertices[ring.back()];
  for (const VertexId v : ring) {
    Point q = complex.vertices[v];
    twice += p.x * q.y - q.x * p.y;
    p = std::move(q);
  }
  return twice / 2;
}

}  // namespace

Rooms rooms(const SegmentSet& input, const ExactComplex& complex, const RoomOptions& options) {
  for (const auto& size : {options.min_area, options.min_width}) {
    if (size && sgn(*size) < 0) {
      throw Error(ErrorCode::BadInput, "a room's least area and width are not negative", {},
                  exact_text(*size));
    }
  }
  Rooms result = rooms_steps::wide_faces(input, complex, options);
  const std::vector<std::size_t> room_of = rooms_steps::room_of_face(result, complex);
  const std::vector<FacePolygon> shapes = polygons(complex);  // of the bounded faces
  const std::vector<FaceId> surrounding = rooms_steps::surrounding_faces(complex, shapes);
  for (Room& room : result.rooms) {
    room.gross_area = area_within(complex, shapes[room.face - 1].outer);
    const std::size_t around =
        rooms_steps::room_around(surrounding, room_of, surrounding[room.face]);
    if (around != rooms_steps::kNoRoom) room.parent = around;
  }
  rooms_steps::name_rooms(result, input, complex, surrounding);
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

// Rooms as JSON; documented in docs/json.md.

#include "output/json/input.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace json {
namespace {

auto neighbour(const RoomNeighbour& next) {
  return object(member("room", next.room + 1), member("shared", next.shared),
                member("across", next.across), member("door", next.door));
}

auto room(const Rooms& rooms, std::size_t r) {
  const Room& room = rooms.rooms[r];
  const auto square_metres = [&] {
    return member("area_m2", nearest_double(room.area * rooms.unit->metres * rooms.unit->metres));
  };
  std::optional<std::size_t> parent;
  if (room.parent) parent = *room.parent + 1;
  return object(
      member("room", r + 1), member("names", room.names), member("layers", room.layers),
      member("area", nearest_double(room.area)), member("area_exact", exact_text(room.area)),
      when(rooms.unit.has_value(), square_metres),
      member("gross_area", nearest_double(room.gross_area)),
      member("gross_area_exact", exact_text(room.gross_area)), member("perimeter", room.perimeter),
      member("width", room.width), member("middle", room.middle), member("depth", room.depth),
      member("parent", parent), member("face", room.face),
      member("neighbours", list(room.neighbours, neighbour)));
}

}  // namespace
}  // namespace json

std::string to_json(const Rooms& rooms, const SegmentSet& input) {
  using namespace json;
  const auto unit = [&] {
    return member("unit", object(member("name", rooms.unit->name),
                                 member("metres", exact_text(rooms.unit->metres))));
  };
  const auto outside = [&](std::size_t i) { return input.labels[i].text; };
  return document(object(
      member("format", "plumbline rooms 1"), member("exact", input.ledger.empty()),
      when(rooms.unit.has_value(), unit), member("min_area", exact_text(rooms.min_area)),
      member("min_width", exact_text(rooms.min_width)), member("narrow", rooms.narrow),
      member("small", rooms.small),
      member("rooms", list(rooms.rooms.size(), [&](std::size_t r) { return room(rooms, r); })),
      member("texts_outside", list(rooms.outside, outside)), input_members(input)));
}

}  // namespace plumbline

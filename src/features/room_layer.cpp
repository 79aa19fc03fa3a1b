// Rooms as polygons with what is known of them.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "features/parts.hpp"
#include "plumbline/features.hpp"

namespace plumbline {
namespace {

using features::number;

/// Numbers of rooms, from 1.
template <class Test>
std::string neighbours_where(const Room& room, Test test) {
  std::string text;
  for (const RoomNeighbour& next : room.neighbours) {
    if (test(next)) text += fmt::format("{}{}", text.empty() ? "" : " ", next.room + 1);
  }
  return text;
}

/// What is known of the room; of a part of one its own area and perimeter.
std::vector<FeatureValue> values_of(const Rooms& rooms, std::size_t r, const Rational& area,
                                    double perimeter, FaceId face) {
  const Room& room = rooms.rooms[r];
  std::vector<FeatureValue> values{number(r + 1), fmt::format("{}", fmt::join(room.names, "; ")),
                                   nearest_double(area), exact_text(area)};
  if (rooms.unit) {
    const Rational square = rooms.unit->metres * rooms.unit->metres;
    values.emplace_back(nearest_double(area * square));
  }
  values.emplace_back(perimeter);
  values.emplace_back(fmt::format("{}", fmt::join(room.layers, "; ")));
  values.push_back(number(room.depth));
  values.push_back(room.parent ? number(*room.parent + 1) : FeatureValue());
  values.emplace_back(neighbours_where(room, [](const RoomNeighbour&) { return true; }));
  values.emplace_back(neighbours_where(room, [](const RoomNeighbour& next) { return next.door; }));
  values.push_back(number(face));
  return values;
}

}  // namespace

FeatureLayer room_layer(const Rooms& rooms, const Rounding& rounding) {
  FeatureLayer layer{"rooms", FeatureGeometry::Polygon, {"room", "name", "area", "area_exact"}, {}};
  if (rooms.unit) layer.columns.emplace_back("area_m2");
  for (const char* column :
       {"perimeter", "layers", "depth", "parent", "neighbours", "doors", "face"}) {
    layer.columns.emplace_back(column);
  }
  std::map<std::size_t, std::size_t> room_of_face;
  for (std::size_t r = 0; r < rooms.rooms.size(); ++r) room_of_face[rooms.rooms[r].face] = r;
  std::vector<std::vector<FacePolygon>> parts(rooms.rooms.size());
  for (FacePolygon& polygon : polygons(rounding.complex)) {
    const auto room = room_of_face.find(rounding.face_origin.at(polygon.face));
    if (room != room_of_face.end()) parts[room->second].push_back(std::move(polygon));
  }
  std::vector<Rational> areas;
  std::vector<double> lengths;
  if (!rounding.has_same_incidences()) {
    areas = face_areas(rounding.complex);
    lengths = perimeters(rounding.complex);
  }
  for (std::size_t r = 0; r < parts.size(); ++r) {
    const bool is_whole = parts[r].size() == 1;
    for (const FacePolygon& polygon : parts[r]) {
      layer.features.push_back(
          {features::parts(rounding.complex, polygon),
           values_of(rooms, r, is_whole ? rooms.rooms[r].area : areas.at(polygon.face),
                     is_whole ? rooms.rooms[r].perimeter : lengths.at(polygon.face),
                     polygon.face)});
    }
  }
  return layer;
}

}  // namespace plumbline

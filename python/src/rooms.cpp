// Rooms of a plan.

#include "plumbline/rooms.hpp"

#include <nanobind/stl/tuple.h>

#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "core.hpp"
#include "plumbline/check.hpp"
#include "plumbline/output.hpp"
#include "table.hpp"

namespace plumbline::python {
namespace {

/// The arrangement without its drift, how many places were joined, and how to say that; none where
/// nothing is apart.
std::tuple<std::optional<ExactComplex>, std::size_t, std::string> joined(
    const SegmentSet& input, const ExactComplex& complex, std::size_t threads) {
  const Drift apart = drift(input, complex);
  if (apart.places == 0) return {std::nullopt, 0, ""};
  ExactComplex result = without_drift(input, complex, apart, threads);
  if (const std::vector<Violation> broken = validate(result); !broken.empty()) {
    throw Error(ErrorCode::Internal,
                "the arrangement without drift is not valid: " + broken.front().message);
  }
  return {std::move(result), apart.places, to_text(apart)};
}

SegmentSet with_unit(SegmentSet input, LengthUnit unit) {
  input.unit = std::move(unit);
  return input;
}

Table table_of(const Rooms& rooms, const SegmentSet& input, const ExactComplex& complex,
               std::size_t threads) {
  const Rounding rounding = safely_rounded(complex, {}, {threads, {}});
  return {{{room_layer(rooms, rounding)},
           input.crs,
           note_of(rounding),
           input.layers,
           rooms.unit ? rooms.unit : input.unit}};
}

void bind_room(nb::module_& m) {
  nb::class_<RoomNeighbour>(m, "RoomNeighbour",
                            "A room that another one shares a side with, or faces across a wall.")
      .def_ro("room", &RoomNeighbour::room, "Its index.")
      .def_ro("shared", &RoomNeighbour::shared, "Length of common sides, rounded.")
      .def_ro("across", &RoomNeighbour::across,
              "Length of sides that face each other across something narrow, rounded.")
      .def_ro("door", &RoomNeighbour::door, "Whether a common side lies on a layer of doors.")
      .def("__repr__", [](const RoomNeighbour& n) {
        return std::string("<RoomNeighbour: ")
            .append(std::to_string(n.room))
            .append(n.door ? ", by a door>" : ">");
      });
  nb::class_<Room>(m, "Room", "A bounded face that is large and wide enough.")
      .def_prop_ro(
          "face", [](const Room& room) { return std::size_t{room.face}; },
          "Index of the face in the arrangement.")
      .def_prop_ro(
          "name", [](const Room& room) { return room.names.empty() ? "" : room.names.front(); },
          "The first of its names, or \"\".")
      .def_ro("names", &Room::names,
              "Texts in it, large letters first; then names of elements that it lies in.")
      .def_ro("layers", &Room::layers, "Of the lines that bound it, ascending.")
      .def_ro("area", &Room::area, "Exact, without what lies in it.")
      .def_ro("gross_area", &Room::gross_area, "Exact, with all that lies in it.")
      .def_ro("perimeter", &Room::perimeter, "Rounded.")
      .def_ro("width", &Room::width, "Diameter of the largest circle in it, within 2 percent.")
      .def_ro("middle", &Room::middle, "Centre of that circle: where a text has most space.")
      .def_ro("depth", &Room::depth, "How deep it is nested; 1 for what is in nothing.")
      .def_ro("parent", &Room::parent, "Index of the room that it lies in.")
      .def_ro("neighbours", &Room::neighbours, "By index.")
      .def("__repr__", [](const Room& room) {
        const std::string area = shortest_text(nearest_double(room.area));
        const std::string name = room.names.empty() ? "no name" : room.names.front();
        return std::string("<Room: ").append(name).append(", area ").append(area).append(">");
      });
}

}  // namespace

void bind_rooms(nb::module_& m) {
  bind_table(m);
  bind_room(m);
  nb::class_<Rooms>(m, "Rooms", "The rooms of a drawing, and what was left out.")
      .def_ro("rooms", &Rooms::rooms, "By face: from left to right.")
      .def_ro("min_area", &Rooms::min_area, "As applied.")
      .def_ro("min_width", &Rooms::min_width, "As applied.")
      .def_ro("narrow", &Rooms::narrow, "How many bounded faces are not wide enough.")
      .def_ro("small", &Rooms::small, "How many are not large enough.")
      .def_ro("outside", &Rooms::outside, "Labels in no room: indices.")
      .def_ro("unit", &Rooms::unit, "As used.")
      .def_ro("doubted", &Rooms::doubted, "What the drawing says, and is not believed.")
      .def(
          "to_text",
          [](const Rooms& rooms, const SegmentSet& input, std::optional<std::size_t> listed) {
            return to_text(rooms, input, listed);
          },
          nb::arg("input"), nb::arg("listed").none())
      .def(
          "to_json",
          [](const Rooms& rooms, const SegmentSet& input) { return to_json(rooms, input); },
          nb::arg("input"))
      .def(
          "to_svg",
          [](const Rooms& rooms, const SegmentSet& input, const ExactComplex& complex) {
            return to_svg(rooms, input, complex);
          },
          nb::arg("input"), nb::arg("complex"), nb::call_guard<nb::gil_scoped_release>())
      .def(
          "to_html",
          [](const Rooms& rooms, const SegmentSet& input, const ExactComplex& complex) {
            return to_html(rooms, input, complex);
          },
          nb::arg("input"), nb::arg("complex"), nb::call_guard<nb::gil_scoped_release>())
      .def("table", &table_of, nb::arg("input"), nb::arg("complex"), nb::arg("threads"),
           nb::call_guard<nb::gil_scoped_release>(), "Their polygons, safely rounded.")
      .def("colours", &room_colours, "Per room a number; neighbours have different ones.");
  m.def(
      "rooms",
      [](const SegmentSet& input, const ExactComplex& complex, std::optional<Rational> min_area,
         std::optional<Rational> min_width, std::optional<LengthUnit> unit,
         std::vector<std::string> doors) {
        return rooms(
            input, complex,
            {std::move(min_area), std::move(min_width), std::move(unit), std::move(doors)});
      },
      nb::arg("input"), nb::arg("complex"), nb::arg("min_area").none(), nb::arg("min_width").none(),
      nb::arg("unit").none(), nb::arg("doors"), nb::call_guard<nb::gil_scoped_release>());
  m.def("without_drift", &joined, nb::arg("input"), nb::arg("complex"), nb::arg("threads"),
        nb::call_guard<nb::gil_scoped_release>(),
        "The arrangement with what printed doubles left apart joined, None where nothing is; how "
        "many places; the same in words.");
  m.def("with_unit", &with_unit, nb::arg("input"), nb::arg("unit"));
}

}  // namespace plumbline::python

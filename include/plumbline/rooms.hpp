#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline {

/// What is a room. Numbers in drawing units, and units squared.
struct RoomOptions {
  /// A room's area is at least this. By default 0.5 m2; where there is no unit, what a square half
  /// as wide again as `min_width` has; 0 for a drawing of areas, as below.
  std::optional<Rational> min_area;
  /// A room is at least so wide: the diameter of the largest circle in it. By default 0.5 m, which
  /// walls are not; where there is no unit, what parts the widths of faces most clearly, above one
  /// of a 200th to a 20th of the drawing's longer side; a 200th where nothing does, and 0 where
  /// that leaves nothing. 0 for a drawing of areas: most of its lines are sides of polygons.
  std::optional<Rational> min_width;
  /// Instead of the one that the drawing has, which is not believed where it makes the drawing less
  /// than 3 m long.
  std::optional<LengthUnit> unit;
  /// Names of layers whose lines are doors, `*` and `?` standing for any characters, in any case.
  std::vector<std::string> doors = {"*door*"};
};

/// A room that has a side in common with another one, or faces it across a wall.
struct RoomNeighbour {
  std::size_t room;   ///< index into Rooms::rooms
  double shared = 0;  ///< length of common sides, **rounded**
  double across = 0;  ///< length of sides that face each other across something narrow, **rounded**
  bool door = false;  ///< whether a common side lies on a layer of doors

  friend bool operator==(const RoomNeighbour&, const RoomNeighbour&) = default;
};

/// A bounded face that is large and wide enough.
struct Room {
  FaceId face;
  /// Texts in it, large letters first, of the same height from the top, then from the left; then
  /// names of closed elements that it lies in, of the smallest one first. Each once.
  std::vector<std::string> names;
  std::vector<std::string> layers;  ///< of the lines that bound it, ascending
  Rational area;                    ///< **exact**
  Rational gross_area;              ///< with all that lies in it, **exact**
  double perimeter = 0;             ///< **rounded**
  double width = 0;                 ///< diameter of the largest circle in it, within 2 percent
  PointD middle;                    ///< centre of that circle: where a text has most space
  std::size_t depth = 0;
  std::optional<std::size_t> parent;      ///< the room that it lies in, index into Rooms::rooms
  std::vector<RoomNeighbour> neighbours;  ///< ascending

  friend bool operator==(const Room&, const Room&) = default;
};

/// The rooms of a drawing, and what was left out.
struct Rooms {
  std::vector<Room> rooms;            ///< by face: from left to right
  Rational min_area, min_width;       ///< as applied
  std::size_t narrow = 0, small = 0;  ///< bounded faces that are no rooms: not wide, not large
  std::vector<std::size_t> outside;   ///< labels in no room, indices into SegmentSet::labels
  std::optional<LengthUnit> unit;     ///< as used
  std::optional<LengthUnit> doubted;  ///< what the drawing says, which would make it tiny
  double extent = 0;                  ///< the longer side of the drawing where that is so

  friend bool operator==(const Rooms&, const Rooms&) = default;
};

/// The bounded faces that are rooms, with their names: labels by the exact face that their places
/// lie in; of a face that is no room, as the box around a number, by the room around it, also where
/// a line leads from the box to a wall. A place on a line belongs to no room. Requires: a valid
/// complex of `input`. Cost: O(E log E), for the circles O(k) per try and face of k edges, and for
/// each named element its segments times the rooms in its box. Throws: Error BadInput for a
/// negative size.
Rooms rooms(const SegmentSet& input, const ExactComplex& complex, const RoomOptions& options = {});

/// Colours for a picture, per room: neighbours have different ones, numbered from 0, as few as a
/// greedy choice in order needs.
std::vector<std::size_t> room_colours(const Rooms& rooms);

}  // namespace plumbline

#pragma once

#include <optional>
#include <vector>

#include "repair/work.hpp"

namespace plumbline::repair_steps {

/// The straight line that lines lie on which hang together there, end to end; they move as one.
struct Carrier {
  Point a, b;                 ///< the first and the last end of its lines
  std::vector<LineId> lines;  ///< ascending
  bool is_anchored = false;   ///< one of them is
  Rational squared_length;    ///< from a to b
};

/// Whether a carrier is stronger than another one: anchored, or longer, or further to the left.
bool is_stronger(const Carrier& c, const Carrier& d);

/// The carriers of all lines, and which of them a line lies on.
struct Carriers {
  std::vector<Carrier> carriers;
  std::vector<std::size_t> of_line;  ///< per source of the arrangement
};
Carriers carriers_of(const Work& work, const Arranged& arranged);

/// Pairs of lines, as positions in `line_of`, of which one may lie beside the other within the
/// distance: all that do, and some that do not. Ascending.
std::vector<std::pair<std::size_t, std::size_t>> side_by_side(const Work& work,
                                                              const Arranged& arranged,
                                                              const Rational& distance);

/// The foot of the perpendicular from p.
Point foot(const Carrier& c, const Point& p);
/// Where two lines meet; nothing where they are parallel.
std::optional<Point> meeting(const Carrier& c, const Carrier& d);
/// The squared distance of p from the unbounded line.
Rational squared_distance_from(const Carrier& c, const Point& p);

}  // namespace plumbline::repair_steps

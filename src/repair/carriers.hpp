#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geometry/union_find.hpp"
#include "repair/work.hpp"

namespace plumbline::repair_steps {

/// The straight line that lines lie on which hang together there, end to end; they move as one.
struct Carrier {
  Point a, b;                 ///< the first and the last end of its lines
  std::vector<LineId> lines;  ///< ascending
  bool is_anchored = false;   ///< one of them is
  bool is_curved = false;     ///< at an end a line goes on that turns off by 1 to 30 degrees
  Rational squared_length;    ///< from a to b
};

/// Whether a carrier is stronger than another one: anchored, or longer, or further to the left.
bool is_stronger(const Carrier& c, const Carrier& d);

/// The carriers of an arrangement's lines; made when they are asked for.
class Carriers {
 public:
  Carriers(const Work& work, const Arranged& arranged);

  /// The carrier on which a line lies, by its position in `line_of`.
  std::size_t of_line(std::size_t position) { return sets_.find(position); }
  /// All lines of an edge lie on one carrier.
  std::size_t of_edge(EdgeId e) { return of_line(arranged_.complex.edge_sources[e].front()); }
  const Carrier& operator[](std::size_t carrier);
  /// Per position, whether the line is on a carrier with a line from `first_new` on.
  std::vector<char> are_new(LineId first_new);

 private:
  const Work& work_;
  const Arranged& arranged_;
  UnionFind sets_;
  std::vector<std::vector<std::uint32_t>> members_;
  std::vector<std::vector<EdgeId>> edges_at_;  ///< per vertex
  bool turns_slightly(const Point& end, const Point& from) const;
  std::unordered_map<std::size_t, Carrier> made_;
};

/// Pairs of lines, as positions in `line_of`, of which one may lie beside the other within the
/// distance: all that do, and some that do not; one of each is new. Ascending.
std::vector<std::pair<std::size_t, std::size_t>> side_by_side(const Work& work,
                                                              const Arranged& arranged,
                                                              const Rational& distance,
                                                              const std::vector<char>& is_new);

/// The foot of the perpendicular from p.
Point foot(const Carrier& c, const Point& p);
/// Where two lines meet; nothing where they are parallel.
std::optional<Point> meeting(const Carrier& c, const Carrier& d);
/// The squared distance of p from the unbounded line.
Rational squared_distance_from(const Carrier& c, const Point& p);

}  // namespace plumbline::repair_steps

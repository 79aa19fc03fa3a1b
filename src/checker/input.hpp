#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "line.hpp"
#include "number.hpp"

namespace plumbline_checker {

struct Segment {
  Point first, last;      ///< in the lexicographic order
  bool reversed = false;  ///< whether its row starts with `last`
  Line line;              ///< from first to last
};

struct Input {
  std::vector<Segment> segments;  ///< by rows
  std::vector<Point> points;      ///< by rows
  std::size_t without_length = 0;
  /// Letters that suffice for a coordinate of an end, a point or a crossing in lowest terms, and
  /// some.
  std::size_t longest_coordinate = 0;
};

/// Reads a .lines text. A byte order mark, blanks around fields and \r before \n mean nothing.
/// Throws: BadInput.
Input read_input(std::string_view text);

}  // namespace plumbline_checker

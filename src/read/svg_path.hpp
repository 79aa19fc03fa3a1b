#pragma once

#include <string_view>
#include <vector>

#include "plumbline/geometry.hpp"
#include "read/attribute.hpp"

namespace plumbline {

/// What a shape's coordinates draw, and the pieces that could not be used.
struct Pieces {
  SegmentList segments;
  std::vector<Unusable> refused;
};

/// The straight pieces of path data, in their order. **Exact**. Each curved piece is refused by the
/// name of its command; what follows starts at the curve's end. An error ends the path: what came
/// before is kept, the rest is refused. A closing command at the subpath's start draws nothing.
/// Source: SVG 1.1, 8.3 and F.2.
Pieces parse_path(std::string_view data, Numbers& numbers);

/// The straight pieces of a list of points, closed or not. An error is handled as in path data; a
/// list with an error is not closed. Source: SVG 1.1, 9.6 to 9.7.
Pieces parse_points(std::string_view points, bool closed, Numbers& numbers);

}  // namespace plumbline

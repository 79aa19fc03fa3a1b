#pragma once

#include <string_view>

#include "read/attribute.hpp"
#include "read/svg/pen.hpp"

namespace plumbline {

/// The pieces of path data, in their order. **Exact** where the pen is. A curve that can't be drawn
/// is refused by itself, and the path goes on from its end. An error ends the path: what came
/// before is kept, the rest is refused. A closing command at the subpath's start draws nothing.
/// Source: SVG 1.1, 8.3 and F.2.
Pieces parse_path(std::string_view data, Numbers& numbers, SvgPen pen);

/// The straight pieces of a list of points, closed or not. An error is handled as in path data; a
/// list with an error is not closed. Source: SVG 1.1, 9.6 to 9.7.
Pieces parse_points(std::string_view points, bool closed, Numbers& numbers);

}  // namespace plumbline

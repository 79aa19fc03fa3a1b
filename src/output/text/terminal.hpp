#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// "1 edit", "2 edits".
std::string counted(std::size_t count, std::string_view thing);

/// The first so many bytes, of whole characters, or all of it.
std::string cut(const std::string& text, std::size_t most);

/// Six digits: a terminal is for people, JSON has all of them.
std::string short_number(double value);

/// "(x, y)" in the drawing's own digits where these are few, else with so many decimals that it is
/// right to a hundredth of the tolerance, or to a double's precision.
std::string place_text(const Point& place, double tolerance);

/// The first sources of the segments, a line each behind the indent, and how many more there are.
std::string input_lines(const SegmentSet& input, const std::vector<SegmentId>& segments,
                        std::string_view indent);

}  // namespace plumbline

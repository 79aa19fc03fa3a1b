#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plumbline/geometry.hpp"

namespace plumbline {

/// Six digits: a terminal is for people, JSON has all of them.
std::string short_number(double value);

/// The first sources of the segments, a line each behind the indent, and how many more there are.
std::string input_lines(const SegmentSet& input, const std::vector<SegmentId>& segments,
                        std::string_view indent);

}  // namespace plumbline

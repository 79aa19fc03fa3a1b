#pragma once

#include <string_view>
#include <vector>

#include "plumbline/error.hpp"
#include "plumbline/geometry.hpp"

namespace plumbline::foreign {

using Path = std::vector<Point>;

/// The numbers in a text of points, which blanks and commas separate. Throws: Error BadInput for a
/// word that is no number and for an odd count.
Path points(std::string_view text);

void add_open(SegmentSet& set, const Path& path);
/// The same and the way back to its first point.
void add_closed(SegmentSet& set, const Path& path);

}  // namespace plumbline::foreign

#pragma once

#include <string>

#include "plumbline/plumbline.hpp"

namespace plumbline::cli {

/// "V 12 E 13 F 3 (2 rooms ...)": one line on the complex.
std::string counts_line(const ExactComplex& complex);
/// What was refused, grouped by element and reason, with the first lines; "" if nothing was.
std::string rejected_lines(const SegmentSet& input);
/// Whether every coordinate is what the file says, or what was replaced.
std::string exactness_line(const SegmentSet& input);

}  // namespace plumbline::cli

#pragma once

#include <string>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::certificate_steps {

/// Per vertex, why it is there: "end S K", "cross S T" or "point P", the first of these that
/// applies, with the least numbers. Requires: a canonical complex. Throws: Error Internal for a
/// vertex without a reason.
std::vector<std::string> reasons(const ExactComplex& complex, const SegmentSet& input);

}  // namespace plumbline::certificate_steps

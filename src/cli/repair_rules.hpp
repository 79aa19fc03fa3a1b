#pragma once

#include "cli/report.hpp"

namespace plumbline::cli {

/// The repair beside what rules in use make of the drawing at the largest of its tolerances.
void tell_rules(const SegmentSet& input, const Repair& repaired, Report& report);

}  // namespace plumbline::cli

#pragma once

#include "cli/commands.hpp"

namespace plumbline::cli {

/// Refuses a drawing, or a result, that is empty or of which not all that looks like geometry,
/// unless the arguments are lenient; names what was lost and --lenient. Throws: Error BadInput.
void ensure_all_drawn(const InputArguments& arguments, const std::string& file,
                      const std::vector<Rejected>& rejected, bool is_empty);
/// The same for the arguments' drawing; one of which nothing was lost may be empty.
void ensure_all_drawn(const InputArguments& arguments, const SegmentSet& input);

}  // namespace plumbline::cli

#pragma once

#include <string>

#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/lar_show.hpp"

namespace plumbline {

/// A picture of the run as SVG, in the same way as of LAR's `arrange`; throws as that does.
std::string to_svg(const inters::Trace& trace, const LarPicture& options = {});

/// The run as JSON by the keys of the original's recorded outputs, and why stages have none.
/// Documented in docs/json.md.
std::string to_json(const inters::Trace& trace);

}  // namespace plumbline

#pragma once

#include <string>
#include <vector>

#include "plumbline/check.hpp"

namespace plumbline {

/// "2 edges merged, 1 face missing", the most frequent first, some of them.
std::string kinds(const std::vector<const Finding*>& findings);

/// "2 faces lost (area 3.5, 0.2), 1 face opened (24)"; empty for a group without faces.
std::string faces_text(const FindingGroup& group);

/// One sentence: what happened, where, how large, which stage did it, which radius avoids it.
std::string to_text(const FindingGroup& group, const Check& check);

/// The same for a terminal, some lines that begin with the number, with the first elements.
std::string group_lines(const FindingGroup& group, std::size_t number, const Check& check);

}  // namespace plumbline

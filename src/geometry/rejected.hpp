#pragma once

#include "plumbline/geometry.hpp"

namespace plumbline {

/// A rejected item whose text is one line of at most 60 characters, cut between UTF-8 characters.
Rejected make_rejected(Source source, std::string reason, std::string text, bool harmless = false);
/// The same for a remark.
Remark make_remark(Source source, std::string what, std::string text);

}  // namespace plumbline

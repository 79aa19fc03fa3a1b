#pragma once

#include <string>

namespace plumbline {

/// The text on one line, at most 60 bytes of it, cut between UTF-8 characters.
std::string shown_text(std::string text);

}  // namespace plumbline

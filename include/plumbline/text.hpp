#pragma once

#include <string>
#include <string_view>

namespace plumbline {

// File names, ids and arguments come from outside and may be any bytes.

/// The text with every byte that is no part of valid UTF-8 replaced by U+FFFD.
std::string valid_utf8(std::string_view text);

/// The text for one line of a terminal: control characters, too, as U+FFFD.
std::string line_text(std::string_view text);

}  // namespace plumbline

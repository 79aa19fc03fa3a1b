#pragma once

#include <string>
#include <string_view>

namespace plumbline {

/// The text with every byte that is no part of valid UTF-8 replaced by U+FFFD. File names and ids
/// come from outside and may be anything.
std::string valid_utf8(std::string_view text);

/// The text for one line of a terminal: invalid UTF-8 and control characters as U+FFFD.
std::string line_text(std::string_view text);

/// The text as character data or attribute value of XML 1.0: & < > " ' as entities; invalid UTF-8
/// and the characters that XML forbids (control characters among them) as U+FFFD.
std::string xml_text(std::string_view text);

}  // namespace plumbline

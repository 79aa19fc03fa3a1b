#pragma once

#include <algorithm>
#include <string_view>

namespace plumbline {

// What .lines and CSV have in common: rows of the four numbers of a segment.
constexpr const char* kRowElement = "row";
constexpr std::size_t kRowNumbers = 4;

/// The text without blanks at its ends.
inline std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

}  // namespace plumbline

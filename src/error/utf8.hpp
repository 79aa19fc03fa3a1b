#pragma once

#include <cstddef>
#include <string_view>

namespace plumbline {

/// What stands for what is no character: U+FFFD.
inline constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Length of the valid UTF-8 sequence at the start of the text, which is not empty; 0 if there is
/// none. Overlong forms, surrogates and values beyond U+10FFFF are invalid (Unicode, table 3-7).
std::size_t sequence_length(std::string_view text);

/// Whether the character makes what follows run from right to left, or back: a name could show as
/// another.
bool turns_direction(std::string_view character);

}  // namespace plumbline

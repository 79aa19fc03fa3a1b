#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace plumbline::cli {

/// Whether it is a terminal that goes back to the beginning of its line when told.
bool is_screen(std::FILE* stream);
/// Whether it may be coloured: such a terminal, and nobody has set NO_COLOR.
bool has_colour(std::FILE* stream);
enum class Colour { Bold = 1, Red = 31, Green = 32 };
/// The text as the stream shows it in this colour; as it is, where that has none.
std::string coloured(std::string_view text, Colour colour, std::FILE* stream);
/// The first word in a colour.
std::string first_word_coloured(const std::string& text, Colour colour, std::FILE* stream);
/// A line on standard error that says by whom it is.
void tell(std::string_view text);

/// Its width; 80 where that is not known.
std::size_t columns_of(std::FILE* stream);

/// The number of characters of a text of UTF-8, and the text cut to as many.
std::size_t width_of(std::string_view text);
std::string cut(std::string_view text, std::size_t width);

/// The text with lines of at most so many characters, broken at blanks; what is broken off stands
/// below what it belongs to.
std::string folded(std::string_view text, std::size_t width);

}  // namespace plumbline::cli

// What may be shown of a text from outside.

#include "error/utf8.hpp"

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// Control characters, U+0080 to U+009F too, and the separators U+2028 and U+2029.
bool ends_line(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return first < 0x20U || first == 0x7FU;
  if (first == 0xC2U) return static_cast<unsigned char>(character[1]) < 0xA0U;
  return character == "\xE2\x80\xA8" || character == "\xE2\x80\xA9";
}

}  // namespace

std::size_t sequence_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80U) return 1;
  const std::size_t length = lead >= 0xF0U ? 4 : lead >= 0xE0U ? 3 : 2;
  if (lead < 0xC2U || lead > 0xF4U || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(text[i])) return 0;
  }
  const auto second = static_cast<unsigned char>(text[1]);
  if ((lead == 0xE0U && second < 0xA0U) || (lead == 0xEDU && second > 0x9FU)) return 0;
  if ((lead == 0xF0U && second < 0x90U) || (lead == 0xF4U && second > 0x8FU)) return 0;
  return length;
}

std::string valid_utf8(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    result += length == 0 ? kReplacement : text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result;
}

bool turns_direction(std::string_view character) {
  // In UTF-8: U+061C; U+200E, U+200F; U+202A to U+202E; U+2066 to U+2069.
  if (character == "\xD8\x9C") return true;
  if (character.size() != 3 || !character.starts_with('\xE2')) return false;
  const auto second = static_cast<unsigned char>(character[1]);
  const auto third = static_cast<unsigned char>(character[2]);
  if (second == 0x80U) {
    return third == 0x8EU || third == 0x8FU || (third >= 0xAAU && third <= 0xAEU);
  }
  return second == 0x81U && third >= 0xA6U && third <= 0xA9U;
}

std::string line_text(std::string_view text) {
  std::string result;
  const std::string valid = valid_utf8(text);
  for (std::string_view rest = valid; !rest.empty();) {
    const std::string_view character = rest.substr(0, sequence_length(rest));
    rest.remove_prefix(character.size());
    result += ends_line(character) || turns_direction(character) ? kReplacement : character;
  }
  return result;
}

}  // namespace plumbline

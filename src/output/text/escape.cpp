// Escapes text from outside for the text formats that are written.

#include "output/text/escape.hpp"

#include "error/utf8.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

std::string_view xml_character(std::string_view character) {
  switch (character[0]) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    case '\t':
      return "&#9;";
    case '\n':
      return "&#10;";
    case '\r':
      return "&#13;";
    default:
      break;
  }
  const bool is_control = static_cast<unsigned char>(character[0]) < 0x20U;
  const bool is_noncharacter = character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";
  const bool is_shown = !is_control && !is_noncharacter && !turns_direction(character);
  return is_shown ? character : kReplacement;
}

}  // namespace

std::string xml_text(std::string_view text) {
  const std::string valid = valid_utf8(text);
  std::string_view rest = valid;
  std::string result;
  result.reserve(valid.size());
  while (!rest.empty()) {
    const std::size_t length = sequence_length(rest);
    result += xml_character(rest.substr(0, length));
    rest.remove_prefix(length);
  }
  return result;
}

}  // namespace plumbline

#include "plumbline/error.hpp"

#include <utility>

#include "error/shown_text.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kShownText = 60;

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

std::string one_line(const Place& place, const std::string& message, const std::string& text) {
  std::string line = to_text(place);
  if (!line.empty()) line += ": ";
  line += message;
  if (!text.empty()) line += ": \"" + text + "\"";
  return line_text(line);
}

}  // namespace

std::string shown_text(std::string text) {
  if (text.size() > kShownText) {
    std::size_t end = kShownText - 3;
    while (end > 0 && continues_character(text[end])) --end;
    text.resize(end);
    text += "...";
  }
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return text;
}

std::string to_text(const Place& place) {
  std::string text = place.file;
  if (place.line != 0) text += (text.empty() ? "line " : ":") + std::to_string(place.line);
  if (place.line != 0 && place.column != 0) text += ":" + std::to_string(place.column);
  return text;
}

Error::Error(ErrorCode code, std::string message, Place place, std::string offending_text)
    : std::runtime_error(one_line(place, message, shown_text(offending_text))),
      code_(code),
      place_(std::move(place)),
      message_(std::move(message)),
      offending_text_(shown_text(std::move(offending_text))) {}

void ensure(bool promise, const char* what_is_broken) {
  if (!promise) throw Error(ErrorCode::Internal, what_is_broken);
}

}  // namespace plumbline

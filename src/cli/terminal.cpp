#include "cli/terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace plumbline::cli {
namespace {

bool is_start(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

/// The variable's value; "" where it is not set.
std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

bool is_screen(std::FILE* stream) {
  return ::isatty(::fileno(stream)) != 0 && variable("TERM") != "dumb";
}

bool has_colour(std::FILE* stream) { return is_screen(stream) && variable("NO_COLOR").empty(); }

std::string coloured(std::string_view text, Colour colour, std::FILE* stream) {
  if (!has_colour(stream)) return std::string(text);
  return fmt::format("\033[{}m{}\033[0m", static_cast<int>(colour), text);
}

std::string first_word_coloured(const std::string& text, Colour colour, std::FILE* stream) {
  const std::size_t end = std::min(text.find_first_of(" :\n"), text.size());
  return coloured(text.substr(0, end), colour, stream) + text.substr(end);
}

void tell(std::string_view text) {
  fmt::print(stderr, "{} {}\n", coloured("plumbline:", Colour::Bold, stderr), text);
}

std::size_t columns_of(std::FILE* stream) {
  constexpr std::size_t kUsual = 80;
  ::winsize size{};
  if (::ioctl(::fileno(stream), TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kUsual;
  return size.ws_col;
}

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, is_start));
}

std::string cut(std::string_view text, std::size_t width) {
  std::size_t end = 0;
  for (std::size_t count = 0; end < text.size(); ++end) {
    if (is_start(text[end]) && ++count > width) break;
  }
  return std::string(text.substr(0, end));
}

}  // namespace plumbline::cli

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

/// Where the text of a line begins: behind blanks, or behind a title ("signature    5c...").
std::size_t indent_of(std::string_view line) {
  constexpr std::size_t kWidestTitle = 20;
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t gap = line.find("  ", begin);
  if (begin > 0 || gap > kWidestTitle) return begin + 2;
  return std::min(line.find_first_not_of(' ', gap), line.size());
}

}  // namespace

bool is_screen(std::FILE* stream) {
  const std::string_view kind = variable("TERM");
  return ::isatty(::fileno(stream)) != 0 && !kind.empty() && kind != "dumb";
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

std::string folded(std::string_view text, std::size_t width) {
  std::string result;
  for (std::size_t end = 0; !text.empty(); text.remove_prefix(std::min(end + 1, text.size()))) {
    end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    const std::string indent(indent_of(line), ' ');
    while (width_of(line) > width) {
      const std::size_t fits = cut(line, width + 1).rfind(' ');
      if (fits == std::string::npos || fits <= indent.size()) break;
      result += line.substr(0, fits) + '\n';
      line.replace(0, fits + 1, indent);
    }
    result += line + (end < text.size() ? "\n" : "");
  }
  return result;
}

std::string cut(std::string_view text, std::size_t width) {
  std::size_t end = 0;
  for (std::size_t count = 0; end < text.size(); ++end) {
    if (is_start(text[end]) && ++count > width) break;
  }
  return std::string(text.substr(0, end));
}

}  // namespace plumbline::cli

#include "output/patch/xml_text.hpp"

#include <algorithm>
#include <array>

namespace plumbline::patch {
namespace {

constexpr std::size_t kNone = std::string_view::npos;

/// Behind the '>' that ends the tag which begins there; quotes may hold others.
std::size_t end_of_tag(std::string_view text, std::size_t at) {
  char quote = '\0';
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return at + 1;
    }
  }
  return kNone;
}

/// Behind a comment and the like that begins there; the same place where none does.
std::size_t behind_other(std::string_view text, std::size_t at) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kOthers{
      {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}}};
  for (const auto& [begin, end] : kOthers) {
    if (!text.substr(at).starts_with(begin)) continue;
    const std::size_t found = text.find(end, at + begin.size());
    return found == kNone ? kNone : found + end.size();
  }
  return at;
}

/// Where the tag that ends the element begins; `at` is behind its first one.
std::size_t closing_tag(std::string_view text, std::size_t at) {
  for (std::size_t depth = 1; (at = text.find('<', at)) != kNone;) {
    if (const std::size_t behind = behind_other(text, at); behind != at) {
      if (behind == kNone) return kNone;
      at = behind;
      continue;
    }
    const std::size_t end = end_of_tag(text, at);
    if (end == kNone) return kNone;
    if (text[at + 1] == '/') {
      if (--depth == 0) return at;
    } else if (text[end - 2] != '/') {
      ++depth;
    }
    at = end;
  }
  return kNone;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

void read_attributes(std::string_view tag, XmlElement& element) {
  std::size_t at = 1 + element.name.size();
  while (at < tag.size()) {
    while (at < tag.size() && is_blank(tag[at])) ++at;
    const std::size_t equals = tag.find('=', at);
    if (equals == kNone) return;
    std::size_t end = equals;
    while (end > at && is_blank(tag[end - 1])) --end;
    const std::string_view name = tag.substr(at, end - at);
    const std::size_t open = tag.find_first_of("\"'", equals);
    const std::size_t close = open == kNone ? kNone : tag.find(tag[open], open + 1);
    if (close == kNone) return;
    element.attributes.emplace_back(name, tag.substr(open, close + 1 - open));
    at = close + 1;
  }
}

}  // namespace

std::vector<std::size_t> line_begins(std::string_view text) {
  std::vector<std::size_t> begins{0};
  for (std::size_t at = 0; (at = text.find('\n', at)) != kNone;) begins.push_back(++at);
  return begins;
}

std::optional<XmlElement> element_at(std::string_view text, std::size_t begin) {
  if (begin >= text.size() || text[begin] != '<') return std::nullopt;
  const std::size_t tag_end = end_of_tag(text, begin);
  if (tag_end == kNone) return std::nullopt;
  XmlElement element;
  element.begin = begin;
  element.end = tag_end;
  const std::string_view tag = text.substr(begin, tag_end - begin);
  element.name = tag.substr(1, std::min(tag.find_first_of(" \t\r\n/>"), tag.size()) - 1);
  read_attributes(tag, element);
  if (tag[tag.size() - 2] == '/') return element;
  const std::size_t closing = closing_tag(text, tag_end);
  if (closing == kNone) return std::nullopt;
  element.content = text.substr(tag_end, closing - tag_end);
  element.end = end_of_tag(text, closing);
  return element.end == kNone ? std::nullopt : std::optional(element);
}

}  // namespace plumbline::patch

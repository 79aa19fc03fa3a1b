#include "output/patch/dxf_text.hpp"

#include <algorithm>
#include <charconv>

namespace plumbline::patch {
namespace {

std::string_view without_blanks(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

std::vector<DxfGroup> DxfText::own_groups(const DxfRecord& record) const {
  constexpr int kApplication = 102, kExtended = 1000;
  std::vector<DxfGroup> own;
  bool is_foreign = false;
  for (std::size_t i = 0; i < record.groups; ++i) {
    const DxfGroup& group = groups[record.first_group + i];
    if (group.code == kApplication) {
      is_foreign = group.value.starts_with('{');
    } else if (!is_foreign && group.code < kExtended) {
      own.push_back(group);
    }
  }
  return own;
}

std::string_view DxfText::value(const DxfRecord& record, int code) const {
  for (const DxfGroup& group : own_groups(record)) {
    if (group.code == code) return group.value;
  }
  return {};
}

std::optional<DxfText> dxf_text_of(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  DxfText result;
  result.text = text;
  const char end_of_line = text.find('\n') != std::string_view::npos ? '\n' : '\r';
  result.line_end = end_of_line == '\r'                           ? "\r"
                    : text.find("\r\n") != std::string_view::npos ? "\r\n"
                                                                  : "\n";
  std::size_t at = text.starts_with(kMark) ? kMark.size() : 0;
  std::uint32_t line = 0;
  std::string_view section;
  const auto take_line = [&] {
    const std::size_t end = std::min(text.find(end_of_line, at), text.size());
    const std::string_view taken = text.substr(at, end - at);
    at = std::min(end + 1, text.size());
    ++line;
    return without_blanks(taken);
  };
  while (text.find_first_not_of(" \t\r\n\x1a", at) != std::string_view::npos) {
    DxfGroup group;
    group.begin = at;
    const std::string_view code = take_line();
    const auto [last, error] = std::from_chars(code.data(), code.data() + code.size(), group.code);
    if (error != std::errc() || last != code.data() + code.size() || at == text.size()) return {};
    group.value = take_line();
    group.end = at;
    if (group.code == 0) {
      result.records.push_back({group.value, section, line, result.groups.size(), 0});
      if (group.value == "ENDSEC") section = {};
      if (group.value == "EOF") {
        result.records.back().groups = 1;
        result.groups.push_back(group);
        break;  // what follows is no DXF
      }
    } else if (group.code == 2 && !result.records.empty() &&
               result.records.back().type == "SECTION") {
      section = group.value;
    }
    if (result.records.empty()) {
      if (group.code != 999) return {};  // comments alone stand before the first record
      continue;
    }
    result.groups.push_back(group);
    ++result.records.back().groups;
  }
  return result.records.empty() ? std::nullopt : std::optional(std::move(result));
}

}  // namespace plumbline::patch

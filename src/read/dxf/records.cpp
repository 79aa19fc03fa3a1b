#include "read/dxf/records.hpp"

#include <algorithm>
#include <charconv>

#include "plumbline/error.hpp"
#include "read/dxf/names.hpp"

namespace plumbline::dxf {
namespace {

constexpr std::string_view kEnd = "EOF";
constexpr int kComment = 999;
constexpr int kFirstExtendedData = 1000;
constexpr int kApplicationData = 102;
constexpr int kEmbeddedObject = 101;

/// Tells which groups of a record are its own.
class OwnGroups {
 public:
  bool holds(const Group& group) {
    if (group.code == kEmbeddedObject) embedded_ = true;
    if (group.code == kApplicationData) {
      inside_application_ = group.value.starts_with('{');
      return false;
    }
    return !embedded_ && !inside_application_ && group.code < kFirstExtendedData;
  }

 private:
  bool embedded_ = false;
  bool inside_application_ = false;
};

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool parse_integer(std::string_view text, std::int64_t& value) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const char* end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && last == end;
}

RecordReader::RecordReader(std::string_view text, const std::string& file)
    : rest_(text), file_(file), line_end_(text.find('\n') != text.npos ? '\n' : '\r') {
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

std::string_view RecordReader::take_line() {
  const std::string_view line = rest_.substr(0, rest_.find(line_end_));
  rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
  ++line_;
  return trimmed(line);
}

bool RecordReader::next_group() {
  const auto is_nothing = [](char c) {  // 0x1a: the end of files under DOS
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\x1a';
  };
  do {
    if (std::all_of(rest_.begin(), rest_.end(), is_nothing)) return false;
    const std::string_view code_text = take_line();
    std::int64_t code = 0;
    if (!parse_integer(code_text, code) || code < INT32_MIN || code > INT32_MAX) {
      throw Error(ErrorCode::BadInput, "expected a DXF group code", {file_, line_ - 1, 1},
                  in_ascii(code_text));
    }
    if (rest_.empty()) {
      throw Error(ErrorCode::BadInput, "the file ends after a group code", {file_, line_ - 1, 1},
                  std::string(code_text));
    }
    group_.code = static_cast<int>(code);
    group_.line = line_;
    group_.value = take_line();
  } while (group_.code == kComment);
  return true;
}

bool RecordReader::next(Record& record) {
  if (!has_group_ && !next_group()) return false;
  if (group_.code != 0) {
    throw Error(ErrorCode::BadInput,
                "a DXF text begins with group code 0, not " + std::to_string(group_.code),
                {file_, group_.line - 1, 1});
  }
  record.type = group_.value;
  record.line = group_.line;
  record.groups.clear();
  if (record.type == kEnd) {  // what follows is no DXF
    rest_ = {};
    has_group_ = false;
    return true;
  }
  OwnGroups own;
  while ((has_group_ = next_group()) && group_.code != 0) {
    if (!own.holds(group_)) continue;
    if (record.groups.size() == kMaxGroups) {
      throw Error(ErrorCode::Limit, "more than " + std::to_string(kMaxGroups) + " groups",
                  {file_, record.line, 0}, in_ascii(record.type));
    }
    record.groups.push_back(group_);
  }
  return true;
}

}  // namespace plumbline::dxf

// LAR's .lines: a row "x1,y1,x2,y2" per segment.

#include <array>
#include <utility>

#include "geometry/rejected.hpp"
#include "plumbline/read.hpp"
#include "read/attribute.hpp"

namespace plumbline {
namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::size_t kNumbers = 4;

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// The row with everything that is not plain ASCII as '?'.
std::string printable(std::string_view row) {
  constexpr std::size_t kKeptText = 100;
  std::string text(row.substr(0, kKeptText));
  for (char& c : text) {
    if (c < ' ' || c > '~') c = c == '\t' ? ' ' : '?';
  }
  return text;
}

/// Throws: Unusable.
Segment parse_row(std::string_view row, Numbers& numbers) {
  std::array<Rational, kNumbers> values;
  std::size_t count = 0;
  for (bool more = true; more; ++count) {
    const std::string_view field = row.substr(0, row.find(','));
    more = field.size() < row.size();
    row.remove_prefix(more ? field.size() + 1 : field.size());
    if (count < kNumbers) values[count] = numbers.parse(trimmed(field));
  }
  if (count != kNumbers) throw Unusable{"row of " + std::to_string(count) + " values, not 4", {}};
  return {{std::move(values[0]), std::move(values[1])},
          {std::move(values[2]), std::move(values[3])}};
}

}  // namespace

Structure read_lines(std::string_view text, const std::string& file_name) {
  Structure structure;
  structure.files = {file_name};
  structure.root = StructId(0);
  structure.structs.resize(1);
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  Numbers numbers;
  for (std::uint32_t line = 1; !text.empty(); ++line) {
    const std::string_view whole = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(whole.size() + 1, text.size()));
    const std::string_view row = trimmed(whole);
    if (row.empty()) continue;
    const auto column = static_cast<std::uint32_t>(row.data() - whole.data() + 1);
    Source source{0, line, column, "row", "", ""};
    try {
      Segment segment = parse_row(row, numbers);
      structure.structs[0].body.emplace_back(Model{std::move(source), {std::move(segment)}});
    } catch (const Unusable& problem) {
      structure.rejected.push_back(
          make_rejected(std::move(source), problem.reason, printable(row)));
    }
  }
  return structure;
}

}  // namespace plumbline

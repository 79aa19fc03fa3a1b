// LAR's .lines: a row "x1,y1,x2,y2" per segment.

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "geometry/rejected.hpp"
#include "number/leading_decimal.hpp"
#include "plumbline/read.hpp"
#include "read/attribute.hpp"
#include "read/byte_stream.hpp"
#include "read/rows.hpp"

namespace plumbline {
namespace {

using Row = std::array<Number, kRowNumbers>;

/// The row if it is four plain decimals and commas, as rows are.
std::optional<Row> plain_row(std::string_view row, Numbers& numbers) {
  Row values;
  for (std::size_t i = 0; i < kRowNumbers; ++i) {
    LeadingDecimal decimal = leading_decimal(row);
    row.remove_prefix(decimal.length);
    const bool ends = i + 1 < kRowNumbers ? row.starts_with(',') : row.empty();
    if (decimal.length == 0 || !ends) return std::nullopt;
    row.remove_prefix(std::min<std::size_t>(row.size(), 1));
    values[i] = numbers.read(std::move(decimal.value));
  }
  return values;
}

/// Throws: Unusable.
Row parse_row(std::string_view row, Numbers& numbers) {
  Row values;
  std::size_t count = 0;
  for (bool more = true; more; ++count) {
    const std::string_view field = row.substr(0, row.find(','));
    more = field.size() < row.size();
    row.remove_prefix(more ? field.size() + 1 : field.size());
    if (count < kRowNumbers) values[count] = numbers.parse(trimmed(field));
  }
  if (count != kRowNumbers) {
    throw Unusable{"row of " + std::to_string(count) + " values, not 4", {}};
  }
  return values;
}

}  // namespace

Structure read_lines(std::string_view text, const std::string& file_name,
                     const ReadOptions& options) {
  Structure structure;
  structure.files = {file_name};
  structure.root = StructId(0);
  structure.structs.resize(1);
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  Numbers numbers(options.shortest_decimals);
  Model model;
  model.source.element = kRowElement;
  for (std::uint32_t line = 1; !text.empty(); ++line) {
    const std::string_view whole = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(whole.size() + 1, text.size()));
    const std::string_view row = trimmed(whole);
    if (row.empty()) continue;
    const auto column = static_cast<std::uint32_t>(row.data() - whole.data() + 1);
    try {
      std::optional<Row> plain = plain_row(row, numbers);
      auto [ax, ay, bx, by] = plain ? *std::move(plain) : parse_row(row, numbers);
      model.segments.push_back({std::move(ax), std::move(ay)}, {std::move(bx), std::move(by)});
      model.rows.push_back({line, column});
    } catch (const Unusable& problem) {
      structure.rejected.push_back(
          make_rejected({0, line, column, kRowElement, "", ""}, problem.reason, printable(row)));
    }
  }
  numbers.add_to(structure.ledger);
  if (!model.segments.empty()) structure.structs[0].body.emplace_back(std::move(model));
  return structure;
}

}  // namespace plumbline

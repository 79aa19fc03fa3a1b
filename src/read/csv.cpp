// Comma-separated values: rows that are segments, or that hold a geometry as text.

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "read/csv_records.hpp"
#include "read/rows.hpp"
#include "read/wkt.hpp"

namespace plumbline {
namespace {

constexpr std::string_view kNumberNames = "x1, y1, x2, y2";

/// Which columns hold what.
struct Columns {
  std::optional<std::array<std::size_t, kRowNumbers>> numbers;
  std::optional<std::size_t> geometry;
  std::optional<std::size_t> id;
  bool has_header = true;
};

/// The names of the columns in lower case.
std::vector<std::string> names_of(const std::vector<CsvField>& header) {
  std::vector<std::string> names;
  for (const CsvField& field : header) {
    std::string name(trimmed(field.text));
    for (char& c : name) {
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    names.push_back(std::move(name));
  }
  return names;
}

std::optional<std::size_t> column_of(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

template <std::size_t N>
std::optional<std::size_t> find_first(const std::vector<std::string>& names,
                                      const std::array<std::string_view, N>& wanted) {
  for (const std::string_view name : wanted) {
    if (const auto column = column_of(names, name)) return column;
  }
  return std::nullopt;
}

/// The columns that a header names; neither numbers nor geometry where it is none.
Columns columns_of(const std::vector<CsvField>& header) {
  using Names = std::array<std::string_view, kRowNumbers>;
  constexpr std::array<Names, 2> kKnown = {{{"x1", "y1", "x2", "y2"}, {"ax", "ay", "bx", "by"}}};
  constexpr Names kGeometries = {"wkt", "geom", "geometry", "the_geom"};
  constexpr Names kIds = {"id", "fid", "gid", "name"};
  const std::vector<std::string> names = names_of(header);
  Columns columns;
  for (const Names& wanted : kKnown) {
    std::array<std::size_t, kRowNumbers> found{};
    std::size_t count = 0;
    for (const std::string_view name : wanted) {
      if (const auto column = column_of(names, name)) found[count++] = *column;
    }
    if (count == kRowNumbers && !columns.numbers) columns.numbers = found;
  }
  columns.geometry = find_first(names, kGeometries);
  columns.id = find_first(names, kIds);
  return columns;
}

class CsvReader {
 public:
  CsvReader(ByteStream& bytes, const FeatureOptions& options)
      : file_(bytes.file()), records_(bytes), table_(bytes.file(), options) {}

  Structure read() && {
    if (!records_.next()) return std::move(table_).finish();
    read_header();
    if (!columns_.has_header) read_row();
    while (records_.next()) read_row();
    return std::move(table_).finish();
  }

 private:
  void read_header() {
    const std::vector<CsvField>& fields = records_.fields();
    columns_ = columns_of(fields);
    if (columns_.numbers || columns_.geometry) return;
    columns_ = {{{0, 1, 2, 3}}, std::nullopt, std::nullopt, false};
    const bool is_row =
        fields.size() == kRowNumbers &&
        std::all_of(fields.begin(), fields.end(), [](const CsvField& f) { return is_number(f); });
    if (is_row) return;
    throw Error(ErrorCode::BadInput,
                "the first row is neither four numbers nor a header with columns " +
                    std::string(kNumberNames) + " (or ax, ay, bx, by), or wkt",
                place_of(fields.front()), printable(fields.front().text));
  }

  static bool is_number(const CsvField& field) {
    try {
      Numbers().parse(trimmed(field.text));
      return true;
    } catch (const Unusable&) {
      return false;
    }
  }

  Place place_of(const CsvField& field) const { return {file_, field.line, field.column}; }

  void read_row() {
    const std::vector<CsvField>& fields = records_.fields();
    place_.line = fields.front().line;
    place_.column = fields.front().column;
    const std::string_view id = columns_.id ? text_of(*columns_.id) : std::string_view();
    table_.begin_feature();
    try {
      if (columns_.numbers) add_segment(fields);
      if (!columns_.numbers) add_geometry(id);
      table_.name_feature(id);
    } catch (const Unusable& problem) {
      table_.refuse(kRowElement, place_, problem, id);
    }
  }

  /// The field of this column; empty where the row is shorter.
  std::string_view text_of(std::size_t column) const {
    return column < records_.fields().size() ? trimmed(records_.fields()[column].text)
                                             : std::string_view();
  }

  void add_segment(const std::vector<CsvField>& fields) {
    if (!columns_.has_header && fields.size() != kRowNumbers) {
      throw Unusable{"row of " + std::to_string(fields.size()) + " values, not 4",
                     printable(fields.front().text)};
    }
    std::array<Number, kRowNumbers> values;
    for (std::size_t i = 0; i < kRowNumbers; ++i) {
      const std::string_view text = text_of((*columns_.numbers)[i]);
      if (text.empty()) {
        throw Unusable{"row without a value for one of " + std::string(kNumberNames), {}};
      }
      try {
        values[i] = numbers_.parse(text);
      } catch (const Unusable& problem) {
        throw Unusable{problem.reason, printable(text)};
      }
    }
    auto& [ax, ay, bx, by] = values;
    table_.add_segment(kRowElement, place_, {std::move(ax), std::move(ay)},
                       {std::move(bx), std::move(by)});
  }

  void add_geometry(std::string_view id) {
    if (text_of(*columns_.geometry).empty()) throw Unusable{"has no geometry", {}, true};
    const CsvField& field = records_.fields()[*columns_.geometry];
    ByteStream text(field.text, place_of(field));
    try {
      text.skip_blanks();
      if (text.peek() == '0') {
        read_hex_wkb_geometry(text, table_);
      } else {
        read_wkt_geometry(text, table_, numbers_);
      }
      text.skip_blanks();
      if (!text.at_end()) text.fail("text behind the geometry");
    } catch (const Error& error) {
      if (error.code() != ErrorCode::BadInput) throw;
      table_.refuse(kRowElement, error.place(), {error.message(), error.offending_text()}, id);
    }
  }

  std::string file_;
  CsvRecords records_;
  Columns columns_;
  FeatureTable table_;
  Numbers& numbers_ = table_.numbers();
  Place place_;  ///< of the row
};

}  // namespace

Structure read_csv(ByteStream& bytes, const FeatureOptions& options) {
  return CsvReader(bytes, options).read();
}

Structure read_csv(std::string_view text, const std::string& file_name,
                   const ReadOptions& options) {
  ByteStream bytes(text, {file_name, 1, 1});
  return read_csv(bytes, feature_options(options));
}

}  // namespace plumbline

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::dxf {

/// A group: a line with its code, a line with its value.
struct Group {
  int code = 0;
  std::uint32_t line = 0;  ///< of the value
  std::string_view value;  ///< without surrounding blanks
};

/// A group of code 0 and the groups up to the next one: an entity, an entry of a table, a bracket.
struct Record {
  std::string_view type;   ///< "LINE", "LAYER", "SECTION", ...
  std::uint32_t line = 0;  ///< of the type
  std::vector<Group> groups;
};

/// Most groups that a record may have.
inline constexpr std::size_t kMaxGroups = std::size_t{1} << 24U;

/// Cuts a DXF text into records. Left out: comments (code 999), data of applications (1000 and
/// more, 102 from "{..." to "}"), embedded objects (from 101 on) and all after the record EOF.
/// Lines end in LF or CR LF; in CR where the text has no LF.
class RecordReader {
 public:
  /// Requires: both outlive the reader and the records.
  RecordReader(std::string_view text, const std::string& file);

  /// Replaces `record` by the next one; false after the last. Throws: Error BadInput, with its
  /// line, for a line that should be a group code and is not, a code without value, and groups
  /// before the first record; Limit beyond kMaxGroups.
  bool next(Record& record);
  /// The line that comes next, counted from 1.
  std::uint32_t line() const { return line_; }

 private:
  bool next_group();
  std::string_view take_line();

  std::string_view rest_;
  const std::string& file_;
  char line_end_;
  std::uint32_t line_ = 1;
  Group group_;             ///< the one read last
  bool has_group_ = false;  ///< whether it begins the next record
};

/// The text without surrounding blanks.
std::string_view trimmed(std::string_view text);
/// The integer that the text is, all of it; false where it is none.
bool parse_integer(std::string_view text, std::int64_t& value);

}  // namespace plumbline::dxf

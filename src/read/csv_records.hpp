#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "read/byte_stream.hpp"

namespace plumbline {

/// A field of a record without its quotes; its place is that of its first byte.
struct CsvField {
  std::string_view text;
  std::uint32_t line = 0, column = 0;
};

/// The records of comma-separated values (RFC 4180): fields may stand in double quotes, and then
/// hold separators, line ends and doubled quotes. Blank records are skipped. The
/// separator (comma, semicolon or tab) is the one that the first line has most of, or says in
/// `sep=`.
class CsvRecords {
 public:
  explicit CsvRecords(ByteStream& bytes);

  /// Reads the next record; false at the end. Throws: Error BadInput for a quote that is not
  /// closed, Limit for a record of more than kMaxRecord bytes.
  bool next();
  /// Of the record, until the next one is read.
  const std::vector<CsvField>& fields() const { return fields_; }
  char separator() const { return separator_; }

  static constexpr std::size_t kMaxRecord = std::size_t{1} << 28U;

 private:
  void find_separator();
  bool take_line_in_memory();
  void take_any_record();
  void take_field();

  ByteStream& bytes_;
  char separator_ = ',';
  std::vector<CsvField> fields_;
  std::string text_;               ///< of the record, where quotes were taken off
  std::vector<std::size_t> ends_;  ///< of the fields in it
  bool is_open_ = false;           ///< whether the record goes on behind the field
};

}  // namespace plumbline

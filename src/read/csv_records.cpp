#include "read/csv_records.hpp"

#include <algorithm>

namespace plumbline {
namespace {

constexpr char kQuote = '"';

bool ends_line(char c) { return c == '\n' || c == '\r'; }

/// How often the character stands in the text outside of quotes.
std::size_t count_unquoted(std::string_view text, char c) {
  std::size_t count = 0;
  bool is_quoted = false;
  for (const char t : text) {
    if (t == kQuote) is_quoted = !is_quoted;
    if (t == c && !is_quoted) ++count;
  }
  return count;
}

}  // namespace

// No library: those in Debian (libcsv, fast-cpp-csv-parser) do not say where a field stands, and
// keep in memory whatever follows a quote that is not closed, or need the columns at compile time.
CsvRecords::CsvRecords(ByteStream& bytes) : bytes_(bytes) { find_separator(); }

void CsvRecords::find_separator() {
  constexpr std::string_view kSeparators = ",;\t";
  constexpr std::string_view kStated = "sep=";
  bytes_.skip_blanks();
  constexpr std::size_t kLongestHeader = std::size_t{1} << 16U;
  const std::string_view ahead = bytes_.ahead(kLongestHeader).substr(0, kLongestHeader);
  const std::string_view line = ahead.substr(0, ahead.find_first_of("\r\n"));
  if (line.size() == kStated.size() + 1 && line.starts_with(kStated)) {
    separator_ = line.back();
    bytes_.advance(line.size());
    return;
  }
  separator_ = *std::max_element(kSeparators.begin(), kSeparators.end(), [line](char a, char b) {
    return count_unquoted(line, a) < count_unquoted(line, b);
  });
}

bool CsvRecords::next() {
  do {
    while (ends_line(bytes_.peek())) bytes_.take();
    if (bytes_.at_end()) return false;
    fields_.clear();
    if (!take_line_in_memory()) take_any_record();
  } while (fields_.size() == 1 && fields_[0].text.find_first_not_of(" \t") == std::string::npos);
  return true;
}

/// The next line, if it is in memory as a whole and without quotes, as nearly all are.
bool CsvRecords::take_line_in_memory() {
  const std::string_view ahead = bytes_.ahead();
  std::string_view line = ahead.substr(0, ahead.find('\n'));
  if (line.size() == ahead.size() || line.find(kQuote) != line.npos) return false;
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (line.find('\r') != line.npos) return false;
  const Place& place = bytes_.place();
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator_, begin), line.size());
    const auto column = static_cast<std::uint32_t>(begin);
    fields_.push_back({line.substr(begin, end - begin), place.line, place.column + column});
    begin = end + 1;
  }
  bytes_.advance(line.size());
  return true;
}

void CsvRecords::take_any_record() {
  text_.clear();
  ends_.clear();
  do {
    take_field();
    ends_.push_back(text_.size());
  } while (is_open_);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    fields_[i].text = std::string_view(text_).substr(begin, ends_[i] - begin);
    begin = ends_[i];
  }
}

void CsvRecords::take_field() {
  const Place begin = bytes_.place();
  fields_.push_back({{}, begin.line, begin.column});
  bool is_quoted = bytes_.peek() == kQuote;
  if (is_quoted) bytes_.take();
  for (;;) {
    const bool at_end = bytes_.at_end();
    if (at_end && is_quoted) {
      throw Error(ErrorCode::BadInput, "a quote is not closed", begin);
    }
    const char c = bytes_.peek();
    if (at_end || (!is_quoted && (ends_line(c) || c == separator_))) break;
    bytes_.take();
    if (is_quoted && c == kQuote) {
      is_quoted = bytes_.peek() == kQuote;  // doubled, it is one
      if (!is_quoted) continue;
      bytes_.take();
    }
    text_ += c;
    if (text_.size() > kMaxRecord) {
      throw Error(ErrorCode::Limit, "record of more than 256 MiB", begin);
    }
  }
  is_open_ = !bytes_.at_end() && bytes_.peek() == separator_;
  if (is_open_) bytes_.take();
}

}  // namespace plumbline

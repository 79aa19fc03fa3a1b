#include "read/first_bytes.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "read/dxf/binary.hpp"
#include "read/gzip.hpp"

namespace plumbline {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\f\v";
constexpr std::string_view kMark = "\xEF\xBB\xBF";

std::string_view without_blanks(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
char upper(char c) { return is_letter(c) ? static_cast<char>(c & ~0x20) : c; }

/// The first line that is neither empty nor a comment (#), without blanks around it, in upper case.
std::string first_line(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find_first_of("\r\n"), bytes.size());
    const std::string_view line = without_blanks(bytes.substr(0, end));
    if (!line.empty() && line.front() != '#') {
      std::string text(line);
      std::ranges::transform(text, text.begin(), upper);
      return text;
    }
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  return {};
}

bool is_wkt(std::string_view line) {
  constexpr std::array<std::string_view, 12> kWords{
      "SRID",           "POINT",         "LINE",         "POLYGON",  "MULTI", "GEOMETRYCOLLECTION",
      "CIRCULARSTRING", "COMPOUNDCURVE", "CURVEPOLYGON", "TRIANGLE", "TIN",   "POLYHEDRALSURFACE"};
  const std::size_t end = line.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ");
  if (end == 0 || end == line.npos || line.find_first_of(" (=", end) != end) return false;
  return std::ranges::any_of(kWords, [&](std::string_view word) { return line.starts_with(word); });
}

/// Whether it is a header with columns that are drawn.
bool is_csv(std::string line) {
  constexpr std::array<std::string_view, 6> kNames{"X1",   "AX",       "WKT",
                                                   "GEOM", "GEOMETRY", "THE_GEOM"};
  if (line.starts_with("SEP=")) return true;
  std::ranges::replace_if(
      line, [](char c) { return c == ';' || c == '\t'; }, ',');
  std::erase_if(line, [](char c) { return c == '"' || c == ' '; });
  line = ',' + line + ',';
  return std::ranges::any_of(kNames, [&](std::string_view name) {
    return line.find(',' + std::string(name) + ',') != std::string::npos;
  });
}

/// Bytes of a geometry: the order of bytes, then a type of two bytes that matter.
bool is_wkb(std::string_view bytes) {
  constexpr std::size_t kHead = 5, kHexHead = 18;
  if (bytes.size() < kHead) return false;
  if (bytes[0] == '\x01') return bytes[3] == '\0';
  if (bytes[0] == '\0') return bytes[2] == '\0';
  const std::string line = first_line(bytes);
  return line.size() >= kHexHead && (line.starts_with("00") || line.starts_with("01")) &&
         line.find_first_not_of("0123456789ABCDEF") == std::string::npos;
}

/// A row of four numbers.
bool is_lines(std::string_view line) {
  return std::ranges::count(line, ',') == 3 &&
         line.find_first_not_of("0123456789+-.E/, \t") == std::string_view::npos;
}

}  // namespace

std::string_view format_by_first_bytes(std::string_view bytes) {
  if (is_gzip(bytes)) return "svgz";
  if (dxf::is_binary(bytes)) return "dxf";
  if (is_wkb(bytes)) return "wkb";
  if (bytes.starts_with(kMark)) bytes.remove_prefix(kMark.size());
  const std::string line = first_line(bytes);
  if (line.starts_with('<')) return "svg";
  if (line.starts_with('{') || line.starts_with('[')) return "json";
  if (line == "0" || line == "999") return "dxf";
  if (is_wkt(line)) return "wkt";
  if (is_csv(line)) return "csv";
  return is_lines(line) ? "lines" : "";
}

}  // namespace plumbline

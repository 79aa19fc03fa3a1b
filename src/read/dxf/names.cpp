#include "read/dxf/names.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>

#include "read/encoding.hpp"

namespace plumbline::dxf {
namespace {

constexpr std::string_view kUtf8 = "UTF-8";
constexpr std::string_view kFirstUtf8Version = "AC1021";
constexpr std::string_view kEscape = "\\U+";
constexpr std::size_t kEscapeDigits = 4;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_plain(char c) { return c >= ' ' && c <= '~' && c != '\\'; }

/// "ANSI_1252", "dos850" -> "CP1252", "CP850"; names that iconv may know stay.
std::string iconv_name(std::string_view code_page) {
  std::string name(code_page);
  std::transform(name.begin(), name.end(), name.begin(), lower);
  const std::size_t digits = name.find_first_of("0123456789");
  if ((name.starts_with("ansi") || name.starts_with("dos")) && digits != name.npos) {
    return "CP" + name.substr(digits);
  }
  return name;
}

void append_utf8(std::string& text, std::uint32_t character) {
  const auto append = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
  constexpr std::uint32_t kLow6 = 0x3fU;
  if (character < 0x80U) {
    append(character);
  } else if (character < 0x800U) {
    append(0xc0U | (character >> 6U));
    append(0x80U | (character & kLow6));
  } else {
    append(0xe0U | (character >> 12U));
    append(0x80U | ((character >> 6U) & kLow6));
    append(0x80U | (character & kLow6));
  }
}

std::string from_latin1(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) append_utf8(text, static_cast<unsigned char>(c));
  return text;
}

/// The character of an escape that the text starts with; none for half of a surrogate pair.
std::optional<std::uint32_t> escaped_character(std::string_view text) {
  if (!text.starts_with(kEscape) || text.size() < kEscape.size() + kEscapeDigits) return {};
  const char* digits = text.data() + kEscape.size();
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(digits, digits + kEscapeDigits, value, 16);
  if (error != std::errc() || end != digits + kEscapeDigits) return {};
  const bool is_surrogate = value >= 0xd800U && value < 0xe000U;
  return is_surrogate || value < ' ' ? std::nullopt : std::optional(value);
}

std::string without_escapes(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto character = escaped_character(text);
    if (character) {
      append_utf8(result, *character);
      text.remove_prefix(kEscape.size() + kEscapeDigits);
    } else {
      result += text.front();
      text.remove_prefix(1);
    }
  }
  return result;
}

}  // namespace

void Names::set_encoding(std::string_view version, std::string_view code_page) {
  // Versions are of one length and ordered as texts.
  if (version.size() == kFirstUtf8Version.size() && version >= kFirstUtf8Version) {
    encoding_ = kUtf8;
  } else if (!code_page.empty()) {
    encoding_ = iconv_name(code_page);
  }
}

std::string Names::utf8(std::string_view bytes) const {
  if (std::all_of(bytes.begin(), bytes.end(), is_plain)) return std::string(bytes);
  std::optional<std::string> converted = utf8_from(bytes, encoding_);
  std::string text = without_escapes(converted ? *converted : from_latin1(bytes));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  }
  return text;
}

std::string Names::key(std::string_view bytes) const {
  std::string text = utf8(bytes);
  std::transform(text.begin(), text.end(), text.begin(), lower);
  return text;
}

std::string in_ascii(std::string_view text) {
  constexpr std::size_t kKept = 100;
  std::string result(text.substr(0, kKept));
  for (char& c : result) {
    if (c < ' ' || c > '~') c = '?';
  }
  return result;
}

}  // namespace plumbline::dxf

#include "read/encoding.hpp"

#include <iconv.h>

#include <algorithm>
#include <cerrno>

namespace plumbline {
namespace {

constexpr std::string_view kUtf8 = "UTF-8";

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_' || c == '.' || c == ':';
}

bool is_name(const std::string& encoding) {
  return !encoding.empty() && std::all_of(encoding.begin(), encoding.end(), is_name_character);
}

/// The value of `encoding` in an XML declaration, empty where there is none.
std::string_view declared_encoding(std::string_view text) {
  if (!text.starts_with("<?xml")) return {};
  text = text.substr(0, text.find("?>"));
  const std::size_t key = text.find("encoding");
  const std::size_t open = text.find_first_of("\"'", key);
  if (key == text.npos || open == text.npos) return {};
  const std::size_t close = text.find(text[open], open + 1);
  return close == text.npos ? std::string_view() : text.substr(open + 1, close - open - 1);
}

bool is_wide(std::string_view encoding) {
  return encoding.starts_with("UTF-16") || encoding.starts_with("utf-16") ||
         encoding.starts_with("UTF-32") || encoding.starts_with("utf-32");
}

std::string_view encoding_of(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\xFF\xFE\0\0"sv) || bytes.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv)) return "UTF-16";
  if (bytes.starts_with("<\0"sv)) return "UTF-16LE";
  if (bytes.starts_with("\0<"sv)) return "UTF-16BE";
  const std::string_view declared = declared_encoding(bytes);
  // A declaration that can be read byte by byte is not in a wide encoding, whatever it says.
  return declared.empty() || is_wide(declared) ? kUtf8 : declared;
}

class Converter {
 public:
  explicit Converter(const std::string& encoding)
      : handle_(iconv_open(kUtf8.data(), encoding.c_str())) {}
  ~Converter() {
    if (valid()) iconv_close(handle_);
  }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;

  bool valid() const { return handle_ != reinterpret_cast<iconv_t>(-1); }

  /// The text up to its first character that can't be converted, and whether that is all of it.
  std::pair<std::string, bool> convert(std::string_view bytes) {
    std::string result(bytes.size() + bytes.size() / 2 + 16, '\0');
    char* from = const_cast<char*>(bytes.data());  // iconv's signature; it does not write there
    std::size_t from_left = bytes.size();
    std::size_t done = 0;
    bool good = true;
    while (good && from_left > 0) {
      char* to = result.data() + done;
      std::size_t to_left = result.size() - done;
      const bool failed = iconv(handle_, &from, &from_left, &to, &to_left) == std::size_t(-1);
      done = static_cast<std::size_t>(to - result.data());
      if (failed && errno == E2BIG) {
        result.resize(2 * result.size());
      } else {
        good = !failed;
      }
    }
    result.resize(done);
    return {std::move(result), good};
  }

 private:
  iconv_t handle_;
};

/// No function, so that it is inlined where it is passed on.
constexpr auto kIsForbidden = [](char c) {
  return (static_cast<unsigned char>(c) < ' ') & (c != '\t') & (c != '\n') & (c != '\r');
};

/// Whether `test` holds for some character. Without early exit, in bytes and in blocks of one size,
/// so that compilers vectorise it.
template <class Test>
bool any_of(std::string_view text, Test test) {
  constexpr std::size_t kBlock = 64;
  unsigned char any = 0;
  const auto look = [&](char c) { any = static_cast<unsigned char>(any | (test(c) ? 1U : 0U)); };
  for (; text.size() >= kBlock; text.remove_prefix(kBlock)) {
    for (std::size_t i = 0; i < kBlock; ++i) look(text[i]);
  }
  for (const char c : text) look(c);
  return any != 0;
}

}  // namespace

Place place_in(std::string_view text, std::size_t offset, const std::string& file) {
  const std::string_view before = text.substr(0, offset);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t line_end = before.rfind('\n');
  const std::size_t column = line_end == before.npos ? offset + 1 : offset - line_end;
  return {file, static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(column)};
}

namespace {

void check_control_characters(std::string_view text, const std::string& file) {
  if (!any_of(text, kIsForbidden)) return;
  const auto control = std::find_if(text.begin(), text.end(), kIsForbidden);
  throw Error(ErrorCode::BadInput, "control character in the text",
              place_in(text, static_cast<std::size_t>(control - text.begin()), file));
}

}  // namespace

std::optional<std::string> utf8_from(std::string_view bytes, const std::string& encoding) {
  if (!is_name(encoding)) return std::nullopt;
  Converter converter(encoding);
  if (!converter.valid()) return std::nullopt;
  auto [text, complete] = converter.convert(bytes);
  return complete ? std::optional(std::move(text)) : std::nullopt;
}

std::string to_utf8(std::string_view bytes, const std::string& file) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::string encoding(encoding_of(bytes));
  const bool plausible = is_name(encoding);
  const auto is_beyond_ascii = [](char c) { return static_cast<unsigned char>(c) >= 0x80U; };
  if (encoding == kUtf8 && !any_of(bytes, is_beyond_ascii)) {
    std::string text(bytes);
    check_control_characters(text, file);
    return text;
  }
  Converter converter(plausible ? encoding : "");
  if (!plausible || !converter.valid()) {
    std::string shown = encoding;
    std::replace_if(shown.begin(), shown.end(), is_beyond_ascii, '?');
    throw Error(ErrorCode::BadInput, "unknown encoding", {file, 1, 1}, std::move(shown));
  }
  auto [text, complete] = converter.convert(bytes);
  if (!complete) {
    throw Error(ErrorCode::BadInput, "text is not valid " + encoding,
                place_in(text, text.size(), file));
  }
  check_control_characters(text, file);
  return std::move(text);
}

}  // namespace plumbline

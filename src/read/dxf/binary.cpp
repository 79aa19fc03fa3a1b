#include "read/dxf/binary.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"

namespace plumbline::dxf {
namespace {

using namespace std::string_view_literals;
constexpr std::string_view kSentinel = "AutoCAD Binary DXF\r\n\x1a\0"sv;

enum class Type { Text, Double, Int16, Int32, Int64, Byte, Chunk };

struct Range {
  int first, last;
  Type type;
};
// DXF reference, "Group code value types".
constexpr std::array kRanges{
    Range{0, 9, Type::Text},        Range{10, 59, Type::Double},   Range{60, 79, Type::Int16},
    Range{90, 99, Type::Int32},     Range{100, 109, Type::Text},   Range{110, 149, Type::Double},
    Range{160, 169, Type::Int64},   Range{170, 179, Type::Int16},  Range{210, 239, Type::Double},
    Range{270, 289, Type::Int16},   Range{290, 299, Type::Byte},   Range{300, 309, Type::Text},
    Range{310, 319, Type::Chunk},   Range{320, 369, Type::Text},   Range{370, 389, Type::Int16},
    Range{390, 399, Type::Text},    Range{400, 409, Type::Int16},  Range{410, 419, Type::Text},
    Range{420, 429, Type::Int32},   Range{430, 439, Type::Text},   Range{440, 459, Type::Int32},
    Range{460, 469, Type::Double},  Range{470, 481, Type::Text},   Range{999, 1003, Type::Text},
    Range{1004, 1004, Type::Chunk}, Range{1005, 1009, Type::Text}, Range{1010, 1059, Type::Double},
    Range{1060, 1070, Type::Int16}, Range{1071, 1071, Type::Int32}};

class BinaryReader {
 public:
  BinaryReader(std::string_view bytes, const std::string& file)
      : bytes_(bytes), position_(kSentinel.size()), file_(file) {
    // The first group is "0 SECTION": a second zero belongs to a code of two bytes.
    wide_codes_ = bytes.size() > position_ + 1 && bytes[position_ + 1] == '\0';
  }

  std::string text() && {
    bool at_end = false;
    while (position_ < bytes_.size() && !at_end) {
      const std::size_t begin = position_;
      const int code = take_code();
      const std::size_t value_begin = text_.size() + std::to_string(code).size() + 1;
      text_ += std::to_string(code) + "\n";
      append_value(code, begin);
      at_end = code == 0 && std::string_view(text_).substr(value_begin) == "EOF";
      text_ += '\n';
      if (text_.size() > kMaxFileSize) {
        throw Error(ErrorCode::Limit,
                    "the text form is larger than " + std::to_string(kMaxFileSize) + " bytes",
                    {file_, 0, 0});
      }
    }
    return std::move(text_);
  }

 private:
  [[noreturn]] void fail(const std::string& why, std::size_t position) const {
    throw Error(ErrorCode::BadInput, why + " at byte " + std::to_string(position), {file_, 0, 0});
  }

  std::string_view take(std::size_t count) {
    if (count > bytes_.size() - position_) fail("the file ends inside a group", position_);
    position_ += count;
    return bytes_.substr(position_ - count, count);
  }

  template <class Unsigned>
  Unsigned take_little_endian() {
    Unsigned value = 0;
    unsigned shift = 0;
    for (const char c : take(sizeof(Unsigned))) {
      value = static_cast<Unsigned>(
          value | (static_cast<Unsigned>(static_cast<unsigned char>(c)) << shift));
      shift += 8;
    }
    return value;
  }

  int take_code() {
    constexpr std::uint8_t kEscape = 255;
    if (wide_codes_) return static_cast<std::int16_t>(take_little_endian<std::uint16_t>());
    const auto code = take_little_endian<std::uint8_t>();
    return code != kEscape ? code : static_cast<std::int16_t>(take_little_endian<std::uint16_t>());
  }

  void append_value(int code, std::size_t begin) {
    const auto* range = std::find_if(kRanges.begin(), kRanges.end(), [code](const Range& r) {
      return r.first <= code && code <= r.last;
    });
    if (range == kRanges.end()) fail("unknown group code " + std::to_string(code), begin);
    switch (range->type) {
      case Type::Text:
        return append_string();
      case Type::Double:
        return append_double(std::bit_cast<double>(take_little_endian<std::uint64_t>()));
      case Type::Int16:
        return append_integer(static_cast<std::int16_t>(take_little_endian<std::uint16_t>()));
      case Type::Int32:
        return append_integer(static_cast<std::int32_t>(take_little_endian<std::uint32_t>()));
      case Type::Int64:
        return append_integer(static_cast<std::int64_t>(take_little_endian<std::uint64_t>()));
      case Type::Byte:
        return append_integer(take_little_endian<std::uint8_t>());
      case Type::Chunk:
        take(take_little_endian<std::uint8_t>());  // never part of a drawing's lines
    }
  }

  void append_integer(std::int64_t value) { text_ += std::to_string(value); }

  void append_double(double value) {
    if (std::isnan(value)) {
      text_ += "nan";
    } else if (std::isinf(value)) {
      text_ += "inf";
    } else {
      text_ += exact_text(rational_from(value));
    }
  }

  void append_string() {
    const std::size_t end = bytes_.find('\0', position_);
    if (end == bytes_.npos) fail("the file ends inside a text", position_);
    const std::size_t begin = text_.size();
    text_ += take(end - position_);
    take(1);
    const auto is_line_break = [](char c) { return c == '\n' || c == '\r'; };
    std::replace_if(text_.begin() + static_cast<std::ptrdiff_t>(begin), text_.end(), is_line_break,
                    ' ');
  }

  std::string_view bytes_;
  std::size_t position_;
  const std::string& file_;
  bool wide_codes_ = false;
  std::string text_;
};

}  // namespace

bool is_binary(std::string_view bytes) { return bytes.starts_with(kSentinel); }

std::string text_of_binary(std::string_view bytes, const std::string& file) {
  return BinaryReader(bytes, file).text();
}

}  // namespace plumbline::dxf

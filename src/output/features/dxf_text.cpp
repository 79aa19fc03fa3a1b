// What DXF R2000 lets texts and numbers be.

#include "output/features/dxf_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "error/utf8.hpp"
#include "plumbline/error.hpp"

namespace plumbline::features {
namespace {

/// Of a valid UTF-8 sequence of two or three bytes its number.
std::uint32_t code_point(std::string_view character) {
  constexpr std::uint32_t kLow6 = 0x3fU;
  const auto byte = [character](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(character[i]));
  };
  if (character.size() == 2) return ((byte(0) & 0x1fU) << 6U) | (byte(1) & kLow6);
  return ((byte(0) & 0x0fU) << 12U) | ((byte(1) & kLow6) << 6U) | (byte(2) & kLow6);
}

std::string upper_hex(std::uint64_t value, std::size_t width) {
  std::array<char, 16> digits{};
  char* end = std::to_chars(digits.data(), digits.data() + digits.size(), value, 16).ptr;
  std::string text(digits.data(), end);
  for (char& c : text) c = 'a' <= c && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c;
  return text.size() < width ? std::string(width - text.size(), '0') + text : text;
}

}  // namespace

std::string dxf_text(std::string_view utf8) {
  constexpr std::uint32_t kNoCharacter = 0xfffdU;
  std::string result;
  const std::string valid = valid_utf8(utf8);
  for (std::string_view rest = valid; !rest.empty();) {
    const std::size_t length = sequence_length(rest);
    const auto first = static_cast<unsigned char>(rest[0]);
    if (length == 1) {
      result += first < ' ' || first == 0x7fU ? ' ' : rest[0];
    } else {  // four bytes: no four digits say it
      result +=
          "\\U+" + upper_hex(length > 3 ? kNoCharacter : code_point(rest.substr(0, length)), 4);
    }
    rest.remove_prefix(length);
  }
  return result;
}

const std::string& LayerNames::legal(const std::string& name) {
  const auto known = legal_.find(name);
  if (known != legal_.end()) return known->second;
  constexpr std::string_view kForbidden = "<>/\\\":;?*|=`',";
  constexpr std::size_t kLongest = 200;  // bytes; 255 are allowed, which escapes count in
  std::string plain = name.substr(0, kLongest);
  for (char& c : plain) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < ' ' || byte == 0x7fU || kForbidden.find(c) != std::string_view::npos) c = '_';
  }
  const std::size_t first = plain.find_first_not_of(' ');
  plain = first == std::string::npos ? "_"
                                     : plain.substr(first, plain.find_last_not_of(' ') + 1 - first);
  const auto key = [](std::string text) {
    for (char& c : text) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
  };
  std::string unique = plain;
  for (std::size_t i = 2; !taken_.insert(key(unique)).second; ++i) {
    unique = plain + "_" + std::to_string(i);
  }
  return legal_.emplace(name, dxf_text(unique)).first->second;
}

void Groups::code(int code) {
  std::array<char, 8> digits{};
  text_.append(digits.data(),
               std::to_chars(digits.data(), digits.data() + digits.size(), code).ptr);
  text_ += '\n';
}

void Groups::text(int code, std::string_view value) {
  this->code(code);
  (text_ += value) += '\n';
}

void Groups::integer(int code, std::int64_t value) {
  std::array<char, 24> digits{};
  char* end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text(code, {digits.data(), end});
}

void Groups::real(int code, double value) {
  std::array<char, 32> digits{};  // the longest is 24
  char* end = std::to_chars(digits.data(), digits.data() + digits.size(), value + 0.0).ptr;
  if (std::all_of(digits.data(), end, [](char c) { return c == '-' || ('0' <= c && c <= '9'); })) {
    *end++ = '.';
    *end++ = '0';
  }
  text(code, {digits.data(), end});
}

void Groups::flat_point(int code, const PointD& p) {
  real(code, p.x);
  real(code + 10, p.y);
}

void Groups::point(int code, const PointD& p) {
  flat_point(code, p);
  text(code + 20, "0.0");
}

std::string Groups::next_handle() const { return upper_hex(handles_, 1); }

std::string Groups::handle() {
  std::string result = next_handle();
  ++handles_;
  text(5, result);
  return result;
}

}  // namespace plumbline::features

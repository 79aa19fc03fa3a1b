#include "read/input_file.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "read/first_bytes.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStandardInput = "/dev/stdin";

[[noreturn]] void fail(ErrorCode code, const std::string& why, const fs::path& file) {
  throw Error(code, why, {file.string(), 0, 0});
}

void check_is_file(const fs::path& file) {
  std::error_code status;
  const fs::file_status kind = fs::status(file, status);
  if (!fs::exists(kind)) fail(ErrorCode::BadFile, "no such file", file);
  if (fs::is_directory(kind)) fail(ErrorCode::BadFile, "is a directory", file);
  if (!fs::is_regular_file(kind)) fail(ErrorCode::BadFile, "is not a regular file", file);
}

[[noreturn]] void fail_as_larger(const fs::path& file, std::uintmax_t most) {
  fail(ErrorCode::Limit, "is larger than " + std::to_string(most) + " bytes", file);
}

std::uintmax_t checked_size(const fs::path& file, std::uintmax_t most) {
  std::error_code status;
  const std::uintmax_t size = fs::file_size(file, status);
  if (status) fail(ErrorCode::BadFile, "cannot be read", file);
  if (size > most) fail_as_larger(file, most);
  return size;
}

/// What comes to its end; `expected` bytes, or more.
std::string content(std::istream& stream, const fs::path& file, std::uintmax_t expected) {
  constexpr std::size_t kBlock = std::size_t{1} << 16U;
  std::string text;
  text.reserve(expected + kBlock);
  // To the end that it has now: pipes, and some files, as those of /proc, have no size beforehand.
  for (std::size_t size = 0; stream; text.resize(size)) {
    text.resize(size + kBlock);
    stream.read(text.data() + size, kBlock);
    size += static_cast<std::size_t>(stream.gcount());
    if (size > kMaxFileSize) fail_as_larger(file, kMaxFileSize);
  }
  const bool is_broken = file == kStandardInput && std::ferror(stdin) != 0;
  if (!stream.eof() || is_broken) fail(ErrorCode::BadFile, "cannot be read", file);
  return text;
}

std::string content_of_file(const fs::path& file, std::uintmax_t expected) {
  std::ifstream stream(file, std::ios::binary);
  return content(stream, file, expected);
}

/// The ending of the file's name, "json", in lower case; none where the name has no dot.
std::optional<std::string> ending_of(const fs::path& file) {
  std::string ending = file.extension().string();
  if (ending.empty()) return std::nullopt;
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return ending.substr(1);
}

}  // namespace

InputFile::InputFile(const fs::path& file) : file_(file) {
  std::error_code ignored;
  if (file == kStandardInput) {
    text_ = content(std::cin, file, 0);
  } else if (fs::is_fifo(file, ignored)) {
    text_ = content_of_file(file, 0);
  } else {
    check_is_file(file);
  }
}

std::string InputFile::text() {
  if (text_) return *std::move(text_);
  return content_of_file(file_, checked_size(file_, kMaxFileSize));
}

ByteStream InputFile::stream() const {
  if (text_) return {*text_, {name(), 1, 1}};
  checked_size(file_, kMaxStreamedFileSize);
  return ByteStream(file_);
}

std::string InputFile::format(std::span<const std::string_view> known, const std::string& asked,
                              const std::string& of) const {
  constexpr std::size_t kBeginning = 4096;
  const std::optional<std::string> ending = ending_of(file_);
  std::string format = asked.empty() ? ending.value_or("") : asked;
  if (asked.empty() && !ending) {
    ByteStream bytes = stream();
    format = format_by_first_bytes(bytes.ahead(kBeginning));
    if (format.empty()) {
      const std::string why = bytes.at_end() ? "it is empty" : "the first bytes tell no format";
      throw Error(ErrorCode::BadInput, "no file name ending, and " + why + " (--from says it)",
                  {name(), 0, 0});
    }
  }
  if (std::ranges::find(known, format) != known.end()) return format;
  std::string names;
  for (const std::string_view one : known) names += " ." + std::string(one);
  const std::string what = asked.empty() && ending ? "unknown file name ending" : "unknown format";
  throw Error(ErrorCode::BadInput, what + of + "; known are" + names, {name(), 0, 0},
              (asked.empty() && ending ? "." : "") + format);
}

}  // namespace plumbline

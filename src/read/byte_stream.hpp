#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "plumbline/error.hpp"

namespace plumbline {

/// The bytes of a text or of a file from the first to the last, with their places. A file is read
/// in blocks, so that memory does not grow with it. A UTF-8 byte order mark at the beginning is
/// left out.
class ByteStream {
 public:
  /// The text, which must outlive the stream; `begin` names it and says where it begins.
  ByteStream(std::string_view text, Place begin);
  /// The content of a regular file. Throws: Error BadFile; so does reading.
  explicit ByteStream(const std::filesystem::path& file);
  /// What the stream has, in blocks of this size.
  ByteStream(std::unique_ptr<std::istream> stream, const std::string& name, std::size_t block_size);

  bool at_end() { return next_ == end_ && !refill(); }
  /// The next byte; 0 at the end.
  char peek() { return at_end() ? '\0' : *next_; }
  char take() { return at_end() ? '\0' : *next_++; }
  void skip_blanks();

  /// What of the rest is in memory: empty only at the end; at least `count` bytes, if that many are
  /// left.
  std::string_view ahead(std::size_t count = 1);
  /// Requires: count <= ahead().size().
  void advance(std::size_t count) { next_ += count; }

  std::uint64_t offset() const {
    return block_offset_ + static_cast<std::uint64_t>(next_ - begin_);
  }
  const std::string& file() const { return place_.file; }
  /// The place of the next byte, until the next call. A line or column beyond 2^32 is 0, unknown.
  /// Cost: of each byte once.
  const Place& place();
  /// Throws from now on: Error Limit where reading goes on `bytes` from here. Until called anew.
  void expect_within(std::uint64_t bytes) { limit_ = offset() + bytes; }
  /// Throws: Error BadInput at the next byte, with what follows on the same line.
  [[noreturn]] void fail(const std::string& message);

 private:
  bool refill(std::size_t kept = 0);
  void grow_block(std::size_t size);
  void count_lines();
  void skip_mark();

  std::unique_ptr<std::istream> stream_;  ///< none for a text, and at the end
  std::vector<char> block_;
  const char* begin_ = nullptr;
  const char* next_ = nullptr;
  const char* end_ = nullptr;
  const char* counted_ = nullptr;   ///< line ends before it are in `lines_`
  std::uint64_t block_offset_ = 0;  ///< of begin_
  std::uint64_t limit_ = ~std::uint64_t{0};
  std::uint64_t lines_ = 0;
  std::uint64_t columns_ = 0;  ///< bytes between the last counted line end and counted_
  std::uint64_t first_line_;
  std::uint64_t first_column_;
  Place place_;
};

/// The text as one line of UTF-8: blanks for control characters, '?' for what is no character.
std::string valid_line(std::string_view text);
/// The text with everything that is not printable ASCII as '?', at most 100 bytes of it.
std::string printable(std::string_view text);

}  // namespace plumbline

#include "read/byte_stream.hpp"

#include <algorithm>
#include <fstream>
#include <limits>

namespace plumbline {
namespace {

constexpr std::size_t kBlockSize = std::size_t{1} << 18U;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::uint32_t known_or_0(std::uint64_t value) {
  return value > std::numeric_limits<std::uint32_t>::max() ? 0 : static_cast<std::uint32_t>(value);
}

}  // namespace

ByteStream::ByteStream(std::string_view text, Place begin)
    : begin_(text.data()),
      next_(begin_),
      end_(begin_ + text.size()),
      counted_(begin_),
      first_line_(begin.line),
      first_column_(begin.column),
      place_(std::move(begin)) {
  skip_mark();
}

ByteStream::ByteStream(const std::filesystem::path& file)
    : ByteStream(std::make_unique<std::ifstream>(file, std::ios::binary), file.string(),
                 kBlockSize) {}

ByteStream::ByteStream(std::unique_ptr<std::istream> stream, const std::string& name,
                       std::size_t block_size)
    : stream_(std::move(stream)),
      block_(block_size),
      first_line_(1),
      first_column_(1),
      place_{name, 1, 1} {
  if (!*stream_) throw Error(ErrorCode::BadFile, "cannot be read", {name, 0, 0});
  begin_ = next_ = end_ = counted_ = block_.data();
  skip_mark();
}

void ByteStream::skip_mark() {
  if (!ahead(kByteOrderMark.size()).starts_with(kByteOrderMark)) return;
  next_ += kByteOrderMark.size();
  counted_ = next_;
}

/// Reads the next block behind the last `kept` bytes, which are those that are left.
bool ByteStream::refill(std::size_t kept) {
  if (stream_ == nullptr) return false;
  count_lines();
  block_offset_ += static_cast<std::uint64_t>(next_ - begin_);
  if (block_offset_ >= limit_) {
    throw Error(ErrorCode::Limit, "more than 256 MiB without end of a value", place());
  }
  std::copy(next_, end_, block_.begin());
  stream_->read(block_.data() + kept, static_cast<std::streamsize>(block_.size() - kept));
  if (stream_->bad()) throw Error(ErrorCode::BadFile, "cannot be read", {place_.file, 0, 0});
  const auto read = static_cast<std::size_t>(stream_->gcount());
  begin_ = next_ = counted_ = block_.data();
  end_ = begin_ + kept + read;
  if (read == 0) stream_.reset();
  return read != 0;
}

std::string_view ByteStream::ahead(std::size_t count) {
  const auto left = [this] { return static_cast<std::size_t>(end_ - next_); };
  for (bool more = true; more && left() < count;) {
    if (block_.size() < count && stream_ != nullptr) grow_block(count);
    more = refill(left());
  }
  return {next_, left()};
}

void ByteStream::grow_block(std::size_t size) {
  count_lines();
  std::vector<char> block(size);
  std::copy(next_, end_, block.begin());
  block_offset_ += static_cast<std::uint64_t>(next_ - begin_);
  end_ = block.data() + (end_ - next_);
  block_ = std::move(block);
  begin_ = next_ = counted_ = block_.data();
}

void ByteStream::skip_blanks() {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
  while (!at_end() && is_blank(*next_)) ++next_;
}

void ByteStream::count_lines() {
  const std::string_view text(counted_, static_cast<std::size_t>(next_ - counted_));
  const std::size_t last = text.rfind('\n');
  if (last == text.npos) {
    columns_ += text.size();
  } else {
    lines_ += static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
    columns_ = text.size() - last - 1;
  }
  counted_ = next_;
}

const Place& ByteStream::place() {
  count_lines();
  place_.line = known_or_0(first_line_ + lines_);
  place_.column = known_or_0((lines_ == 0 ? first_column_ : 1) + columns_);
  return place_;
}

void ByteStream::fail(const std::string& message) {
  const Place here = place();
  const std::string_view rest = ahead();
  throw Error(ErrorCode::BadInput, message, here, printable(rest.substr(0, rest.find('\n'))));
}

namespace {

/// Length of the UTF-8 character that the text begins with; 0 where it is none. Source: The Unicode
/// Standard, table 3-7.
std::size_t character_length(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80U) return 1;
  const std::size_t length = lead >= 0xF0U ? 4 : lead >= 0xE0U ? 3 : 2;
  if (lead < 0xC2U || lead > 0xF4U || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  }
  const bool is_overlong = (lead == 0xE0U && byte(1) < 0xA0U) || (lead == 0xF0U && byte(1) < 0x90U);
  const bool is_beyond = (lead == 0xEDU && byte(1) > 0x9FU) || (lead == 0xF4U && byte(1) > 0x8FU);
  return is_overlong || is_beyond ? 0 : length;
}

}  // namespace

std::string valid_line(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) {
      line += '?';
    } else if (static_cast<unsigned char>(text[0]) < ' ') {
      line += ' ';
    } else {
      line += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return line;
}

std::string printable(std::string_view text) {
  constexpr std::size_t kKeptText = 100;
  std::string result(text.substr(0, kKeptText));
  for (char& c : result) {
    if (c < ' ' || c > '~') c = c == '\t' ? ' ' : '?';
  }
  return result;
}

}  // namespace plumbline

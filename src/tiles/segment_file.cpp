// A record: the segment's number, then four coordinates, each a byte that says how many decimals
// the eight bytes behind it have, or 255 and the length and text of a fraction.

#include "tiles/segment_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "plumbline/error.hpp"
#include "tiles/cell_hash.hpp"

namespace plumbline::tiles {
namespace {

constexpr std::size_t kBlock = 1U << 20;
constexpr unsigned char kFraction = 255;

template <class T>
void append(std::string& text, T value) {
  text.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

template <class T>
T value_of(std::string_view bytes) {
  T value;
  std::memcpy(&value, bytes.data(), sizeof(value));
  return value;
}

void append(std::string& text, const Number& number) {
  if (number.is_decimal()) {
    text += static_cast<char>(number.digits());
    append(text, number.mantissa());
    return;
  }
  const std::string fraction = number.rational().get_str();
  text += static_cast<char>(kFraction);
  append(text, static_cast<std::uint64_t>(fraction.size()));
  text += fraction;
}

std::filesystem::path temporary_of(const std::filesystem::path& file) {
  return fmt::format("{}.{}.new", file.string(), ::getpid());
}

}  // namespace

bool meets(const NumberedSegment& segment, const Strip& strip) {
  return !(strip.left && segment.high() < *strip.left) &&
         !(strip.right && segment.low() > *strip.right);
}

SegmentWriter::SegmentWriter(std::filesystem::path file)
    : file_(std::move(file)), stream_(std::fopen(temporary_of(file_).c_str(), "wb")) {
  if (!stream_) fail();
}

SegmentWriter::~SegmentWriter() {
  if (!stream_) return;
  stream_.reset();
  std::error_code ignored;
  std::filesystem::remove(temporary_of(file_), ignored);
}

void SegmentWriter::write(const NumberedSegment& segment) {
  const std::size_t begin = buffer_.size();
  append(buffer_, segment.number);
  for (const Number& number : segment.at) append(buffer_, number);
  hash_ += bytes_hash(std::string_view(buffer_).substr(begin));
  ++count_;
  if (buffer_.size() >= kBlock) flush();
}

void SegmentWriter::flush() {
  if (std::fwrite(buffer_.data(), 1, buffer_.size(), stream_.get()) != buffer_.size()) fail();
  buffer_.clear();
}

void SegmentWriter::close() {
  flush();
  if (std::fflush(stream_.get()) != 0 || ::fsync(::fileno(stream_.get())) != 0) fail();
  stream_.reset();
  std::error_code error;
  std::filesystem::rename(temporary_of(file_), file_, error);
  if (error) fail();
}

void SegmentWriter::fail() const {
  throw Error(ErrorCode::BadFile, "cannot write to it: " + std::string(std::strerror(errno)),
              {file_.string(), 0, 0});
}

SegmentReader::SegmentReader(const std::filesystem::path& file)
    : file_(file.string()), stream_(std::fopen(file.c_str(), "rb"), &std::fclose) {
  if (!stream_) fail(std::strerror(errno));
}

void SegmentReader::fail(const std::string& what) const {
  throw Error(ErrorCode::BadFile, "cannot read segments of a tile: " + what, {file_, 0, 0});
}

std::string_view SegmentReader::ahead(std::size_t count) {
  if (buffer_.size() - at_ < count) {
    buffer_.erase(0, at_);
    at_ = 0;
    const std::size_t kept = buffer_.size();
    buffer_.resize(kept + std::max(kBlock, count));
    buffer_.resize(kept +
                   std::fread(buffer_.data() + kept, 1, buffer_.size() - kept, stream_.get()));
    if (std::ferror(stream_.get()) != 0) fail(std::strerror(errno));
  }
  return std::string_view(buffer_).substr(at_, count);
}

std::optional<NumberedSegment> SegmentReader::next() {
  constexpr std::size_t kPlain = 8 + 4 * 9;
  const std::string_view head = ahead(kPlain);
  if (head.empty()) return {};
  std::size_t length = 8;
  NumberedSegment result;
  if (head.size() < kPlain) fail("it ends within a segment");
  result.number = value_of<std::uint64_t>(head);
  for (Number& number : result.at) {
    const auto digits = static_cast<unsigned char>(ahead(length + 9)[length]);
    const auto value = value_of<std::uint64_t>(ahead(length + 9).substr(length + 1));
    length += 9;
    if (digits != kFraction) {
      if (digits > Number::kMaxDigits) fail("a number of too many decimals");
      number = Number::decimal(static_cast<std::int64_t>(value), digits);
      continue;
    }
    const std::string_view text = ahead(length + value);
    if (text.size() < length + value) fail("it ends within a number");
    number = Number(Rational(std::string(text.substr(length))));
    length += value;
  }
  hash_ += bytes_hash(ahead(length));
  at_ += length;
  return result;
}

}  // namespace plumbline::tiles

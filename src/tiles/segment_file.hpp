#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/number.hpp"
#include "plumbline/tiles.hpp"

namespace plumbline::tiles {

/// A segment with its number in the whole drawing.
struct NumberedSegment {
  std::uint64_t number = 0;
  std::array<Number, 4> at;  ///< ax, ay, bx, by

  const Number& low() const { return at[0] < at[2] ? at[0] : at[2]; }
  const Number& high() const { return at[0] < at[2] ? at[2] : at[0]; }
};

/// Whether a segment has a point in the strip, its cuts included.
bool meets(const NumberedSegment& segment, const Strip& strip);

/// Writes segments to a file that is there once it is closed.
class SegmentWriter {
 public:
  explicit SegmentWriter(std::filesystem::path file);
  SegmentWriter(SegmentWriter&&) = default;
  ~SegmentWriter();

  void write(const NumberedSegment& segment);
  /// Throws, as `write`: Error BadFile where the disk is full and the like.
  void close();
  std::uint64_t count() const { return count_; }
  /// Of what was written, in its order.
  const CellHash& hash() const { return hash_; }

 private:
  void flush();
  [[noreturn]] void fail() const;

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path file_;
  std::unique_ptr<std::FILE, Close> stream_;
  std::string buffer_;
  std::uint64_t count_ = 0;
  CellHash hash_;
};

class SegmentReader {
 public:
  explicit SegmentReader(const std::filesystem::path& file);
  /// None at the end. Throws: Error BadFile for what a SegmentWriter did not write.
  std::optional<NumberedSegment> next();
  /// Of what was read.
  const CellHash& hash() const { return hash_; }

 private:
  std::string_view ahead(std::size_t count);
  [[noreturn]] void fail(const std::string& what) const;

  std::string file_;
  std::unique_ptr<std::FILE, decltype(&std::fclose)> stream_;
  std::string buffer_;
  std::size_t at_ = 0;
  CellHash hash_;
};

}  // namespace plumbline::tiles

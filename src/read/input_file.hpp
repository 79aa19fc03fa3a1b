#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "read/byte_stream.hpp"

namespace plumbline {

/// The bytes that a name stands for: those of a file, which can be read again; or of a named pipe
/// or of /dev/stdin, which are in memory.
class InputFile {
 public:
  /// Throws: Error BadFile for what is neither; Limit for a pipe of more than kMaxFileSize.
  explicit InputFile(const std::filesystem::path& file);

  const std::string& name() const { return file_.native(); }
  /// Requires: not called before. Throws: Error BadFile; Limit beyond kMaxFileSize.
  std::string text();
  /// From the beginning. Throws: Error BadFile; Limit beyond kMaxStreamedFileSize.
  ByteStream stream() const;
  /// The one of these formats that is asked for; "": that of the ending, or without one of the
  /// first bytes. Throws: Error BadInput, which says of what (" of a result") the formats are.
  std::string format(std::span<const std::string_view> known, const std::string& asked,
                     const std::string& of = "") const;

 private:
  std::filesystem::path file_;
  std::optional<std::string> text_;
};

}  // namespace plumbline

#pragma once

// Every other header comes here before anything that needs it. A header that is not there ends the
// compile, as #error does not: one line, not those that would follow.
#if __cplusplus < 202002L
#include "plumbline needs C++20: compile with -std=c++20"
#endif

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace plumbline {

/// Where something stands in an input file. Line and column count from 1; 0 means unknown.
struct Place {
  std::string file;
  std::uint32_t line = 0;
  std::uint32_t column = 0;

  friend bool operator==(const Place&, const Place&) = default;
};

/// `file:line:column`, leaving out what is unknown.
std::string to_text(const Place& place);

/// Why a job could not be done.
enum class ErrorCode {
  BadInput,   ///< the content of a file or an argument cannot be used
  BadFile,    ///< a file cannot be opened, read or written
  Limit,      ///< a stated limit is exceeded
  Cancelled,  ///< a progress callback asked to stop
  Internal,   ///< a promise of this library is broken: please report it
};

/// Thrown when a job cannot be done. `what()` is one line: place, message and the offending text.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, std::string message, Place place = {}, std::string offending_text = {});

  ErrorCode code() const { return code_; }
  const Place& place() const { return place_; }
  const std::string& message() const { return message_; }
  /// The text that caused the error, shortened to 60 characters; empty where there is none.
  const std::string& offending_text() const { return offending_text_; }

 private:
  ErrorCode code_;
  Place place_;
  std::string message_;
  std::string offending_text_;
};

/// Throws Error with code Internal unless `promise` holds. Always on, in every build type.
void ensure(bool promise, const char* what_is_broken);

// File names, ids and arguments come from outside and may be any bytes.

/// The text with every byte that is no part of valid UTF-8 replaced by U+FFFD.
std::string valid_utf8(std::string_view text);

/// The text for one line of a terminal: control characters, too, and those that turn the direction
/// of what follows, as U+FFFD.
std::string line_text(std::string_view text);

}  // namespace plumbline

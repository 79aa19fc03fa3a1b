#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::programs {

inline constexpr double kGigabyte = 1U << 30U;  ///< in bytes

/// What a program may take.
struct Limits {
  double seconds = 0;
  std::uint64_t bytes = 0;  ///< of memory that it writes to
};

/// How far standard output is read.
enum class Until { Line, End };

/// What became of a program that was sent something.
struct Exchange {
  enum class Ending { Answered, Exited, Signalled, TimedOut };
  Ending ending = Ending::Answered;
  std::string answer;  ///< the line, or all of it; what there was of it where it did not answer
  int code = 0;        ///< of Exited and, after Until::End, of Answered: the exit code; of
                       ///< Signalled: the signal
  std::string said;    ///< the end of standard error
};

/// Runs a program in a session of its own, writes `input` to it and reads its answer. Whatever it
/// started has ended afterwards, also where this process ends meanwhile. A program that answered a
/// line has a moment to end by itself, as its input has ended. Throws: Error BadFile where it
/// cannot be started; Limit for an answer of more than a gigabyte.
Exchange exchange(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                  std::string_view input, const Limits& limits, Until until);

}  // namespace plumbline::programs

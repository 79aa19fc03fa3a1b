#pragma once

#include <signal.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "cli/commands.hpp"
#include "plumbline/detail/new_file.hpp"

namespace plumbline::cli {

/// While it lives, the program ends cleanly, whatever it is doing: a temporary file is removed,
/// an output is there as a whole or not at all.
/// - By SIGINT, SIGTERM, SIGHUP, SIGQUIT or SIGXCPU, unless it is ignored, as by that signal: a
///   shell sees 128 + its number.
/// - After the time limit, with an error and kBadInput.
/// - Where memory cannot be had, beyond the limit or at all, with an error and kBadInput.
/// There can be one, made before other threads are.
class Watchdog {
 public:
  explicit Watchdog(const Limits& limits);
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;
  ~Watchdog();

 private:
  void watch();

  std::optional<std::chrono::steady_clock::time_point> deadline_;
  std::string timeout_;  ///< the error
  ::sigset_t signals_;   ///< and SIGALRM, which wakes the thread at the end
  ::sigset_t blocked_before_;
  std::atomic<bool> done_ = false;
  std::thread thread_;
};

/// Ends the program with an error, in one line, and kBadInput, if need be without any memory. A
/// temporary file is removed.
[[noreturn]] void end_with(std::string_view error);

/// A NewFile whose temporary is removed also if the program is ended.
class WatchedFile {
 public:
  explicit WatchedFile(const std::string& name);
  WatchedFile(const WatchedFile&) = delete;
  WatchedFile& operator=(const WatchedFile&) = delete;
  ~WatchedFile();

  NewFile& file() { return file_; }

 private:
  std::unique_lock<std::recursive_mutex> lock_;
  NewFile file_;
};

}  // namespace plumbline::cli

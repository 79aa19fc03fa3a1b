// Both limits end the program at once: nothing may be thrown through GMP, and a signal may come at
// any time. What is said is put together from parts, without memory.

#include "limits.hpp"

#include <gmp.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string_view>

namespace plumbline_checker {
namespace {

constexpr int kExitCode = 2;

// Arguments of the program, for the handlers.
const char* memory_limit = nullptr;
const char* time_limit = nullptr;

void say(const char* text) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text, std::strlen(text));
}
[[noreturn]] void end(const char* what, const char* option, const char* value) {
  say("plumbline-verify: ");
  say(what);
  if (value != nullptr) {
    say(": more than ");
    say(option);
    say(value);
  }
  say("\n");
  ::_exit(kExitCode);
}

[[noreturn]] void end_without_memory() { end("out of memory", "--max-memory ", memory_limit); }
void end_without_time(int /*signal*/) { end("timeout", "--timeout ", time_limit); }

void* allocate(std::size_t size) {
  void* const memory = std::malloc(size);
  if (memory == nullptr) end_without_memory();
  return memory;
}
void* reallocate(void* old, std::size_t /*old_size*/, std::size_t size) {
  void* const memory = std::realloc(old, size);
  if (memory == nullptr) end_without_memory();
  return memory;
}

}  // namespace

void end_where_memory_ends() {
  std::set_new_handler(end_without_memory);
  mp_set_memory_functions(allocate, reallocate, nullptr);
}

bool limit_memory(const char* size) {
  constexpr std::string_view kUnits = "KMG";
  constexpr unsigned kBitsPerUnit = 10;
  std::string_view text = size;
  unsigned shift = 0;
  if (!text.empty() && kUnits.find(text.back()) != kUnits.npos) {
    shift = kBitsPerUnit * (1 + static_cast<unsigned>(kUnits.find(text.back())));
    text.remove_suffix(1);
  }
  std::uint64_t count = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  const bool is_number = error == std::errc() && rest == text.data() + text.size();
  if (!is_number || count == 0 || count > (UINT64_MAX >> shift)) return false;
  memory_limit = size;
  struct ::rlimit limit = {};
  ::getrlimit(RLIMIT_DATA, &limit);
  limit.rlim_cur = std::min<::rlim_t>(count << shift, limit.rlim_max);
  return ::setrlimit(RLIMIT_DATA, &limit) == 0;
}

bool limit_time(const char* seconds) {
  constexpr double kMost = 1e9;
  constexpr double kMicroseconds = 1e6;
  const char* const last = seconds + std::strlen(seconds);
  double count = 0;
  const auto [rest, error] = std::from_chars(seconds, last, count);
  if (error != std::errc() || rest != last || !(count > 0) || count > kMost) return false;
  time_limit = seconds;
  std::signal(SIGALRM, end_without_time);
  const double whole = std::floor(count);
  // At least a microsecond: 0 would be no limit.
  const double part = std::max((count - whole) * kMicroseconds, whole > 0 ? 0.0 : 1.0);
  struct ::itimerval timer = {};
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec = static_cast<suseconds_t>(part);
  return ::setitimer(ITIMER_REAL, &timer, nullptr) == 0;
}

}  // namespace plumbline_checker

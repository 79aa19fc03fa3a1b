#include "campaign/child.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <system_error>

namespace plumbline::campaign {
namespace {

constexpr rlim_t kMemory = rlim_t{4} << 30U;

// Sanitizers reserve far more addresses than they use.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PLUMBLINE_IS_SANITIZED 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PLUMBLINE_IS_SANITIZED 1
#endif
#ifdef PLUMBLINE_IS_SANITIZED
constexpr bool kLimitsMemory = false;
#else
constexpr bool kLimitsMemory = true;
#endif

[[noreturn]] void throw_system_error(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// What the child does. It leaves without destructors, which belong to its parent.
[[noreturn]] void work_and_leave(const std::function<std::string()>& work, int pipe) {
  const rlimit memory{kMemory, kMemory}, no_core{0, 0};
  if (kLimitsMemory) setrlimit(RLIMIT_AS, &memory);
  setrlimit(RLIMIT_CORE, &no_core);
  for (const int number : {SIGINT, SIGTERM}) signal(number, SIG_IGN);  // the parent decides
  std::string result;
  try {
    result = work();
  } catch (const std::exception& error) {
    result = std::string("throws ") + error.what();
  } catch (...) {
    result = "throws";
  }
  const bool is_written =
      write(pipe, result.data(), result.size()) == static_cast<ssize_t>(result.size());
  _exit(is_written ? EXIT_SUCCESS : EXIT_FAILURE);
}

}  // namespace

Child::Child(const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw_system_error("pipe");
  pid_ = fork();
  if (pid_ < 0) throw_system_error("fork");
  if (pid_ == 0) {
    close(ends[0]);
    work_and_leave(work, ends[1]);
  }
  close(ends[1]);
  pipe_ = ends[0];
}

Child::~Child() {
  if (!has_ended_) end();
  close(pipe_);
}

bool Child::ended_within(double seconds) {
  if (has_ended_) return true;
  // The end of the pipe is closed when the child is gone; what it writes there fits the pipe.
  pollfd waiting{pipe_, POLLIN, 0};
  if (poll(&waiting, 1, static_cast<int>(1000 * seconds)) <= 0) return false;
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0) {
    if (errno != EINTR) throw_system_error("waitpid");
  }
  collect(status);
  return true;
}

void Child::end() {
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
  has_ended_ = true;
  outcome_ = "hang";
}

void Child::collect(int status) {
  has_ended_ = true;
  if (WIFSIGNALED(status)) {
    outcome_ = "crash (signal " + std::to_string(WTERMSIG(status)) + ")";
  } else if (WEXITSTATUS(status) != EXIT_SUCCESS) {
    outcome_ = "crash (exit code " + std::to_string(WEXITSTATUS(status)) + ")";
  } else {
    std::array<char, 4096> text{};
    for (ssize_t n = 0; (n = read(pipe_, text.data(), text.size())) > 0;) {
      outcome_.append(text.data(), static_cast<std::size_t>(n));
    }
  }
}

std::string in_child(const std::function<std::string()>& work, double seconds) {
  Child child(work);
  if (!child.ended_within(seconds)) child.end();
  return child.outcome();
}

}  // namespace plumbline::campaign

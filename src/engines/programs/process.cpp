// A program, its three streams and its end. Between fork and exec nothing is called but what may be
// called in the child of a process with threads.

#include "engines/programs/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
#include <optional>
#include <utility>

#include "plumbline/error.hpp"

namespace plumbline::programs {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kAtOnce = 1U << 16U;         // bytes read or written at a time
constexpr std::size_t kLongestAnswer = 1U << 30U;  // bytes
constexpr std::size_t kMostSaid = 1U << 16U;       // bytes that are kept
constexpr int kLook = 50;                          // milliseconds between looks at the program
constexpr double kGoodbye = 1;  // seconds in which a program that answered may end by itself

[[noreturn]] void fail(const std::string& what, int error) {
  throw Error(ErrorCode::BadFile, what + ": " + std::strerror(error));
}

/// A file descriptor, which is closed in programs that are started.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }
  int operator*() const { return number_; }
  bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

struct Pipe {
  Descriptor out, in;  ///< to be read, to be written

  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("no pipe to a program", errno);
    out = Descriptor(ends[0]);
    in = Descriptor(ends[1]);
  }
};

/// While it lives, writing to a program that has ended is an error and no signal.
class NoBrokenPipes {
 public:
  NoBrokenPipes() {
    ::sigemptyset(&pipe_);
    ::sigaddset(&pipe_, SIGPIPE);
    ::sigset_t pending;
    ::sigpending(&pending);
    was_pending_ = ::sigismember(&pending, SIGPIPE) == 1;
    ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  NoBrokenPipes(const NoBrokenPipes&) = delete;
  NoBrokenPipes& operator=(const NoBrokenPipes&) = delete;
  ~NoBrokenPipes() {
    const ::timespec now = {0, 0};
    if (!was_pending_) ::sigtimedwait(&pipe_, nullptr, &now);
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  ::sigset_t pipe_, before_;
  bool was_pending_ = false;
};

class Process {
 public:
  Process(const std::filesystem::path& program, const std::vector<std::string>& arguments,
          std::uint64_t bytes);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() { end(); }

  /// Until the answer is there, or cannot come any more.
  Exchange exchange(std::string_view input, double seconds, Until until);

 private:
  [[noreturn]] void become(const char* program, char* const* arguments, std::uint64_t bytes);
  [[noreturn]] void guard();
  void write_some(std::string_view& input);
  bool read_some(Descriptor& from, std::string& into);
  void say_the_rest();
  bool has_ended() const;
  bool waits_for_end(double seconds) const;
  void end();

  Pipe input_, output_, errors_;
  Pipe started_;  ///< has the error of exec, where it failed
  Pipe life_;     ///< ends with this process
  ::pid_t program_ = -1, guard_ = -1;
  std::string answer_, said_;
  int status_ = 0;  ///< as waitpid gives it, after `end`
};

Process::Process(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 std::uint64_t bytes) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  program_ = ::fork();
  if (program_ == 0) become(pointers.front(), pointers.data(), bytes);
  if (program_ < 0) fail("no process for " + program.string(), errno);
  input_.out.close();
  output_.in.close();
  errors_.in.close();
  started_.in.close();
  guard_ = ::fork();
  if (guard_ == 0) guard();
  if (guard_ < 0) {
    const int error = errno;
    end();
    fail("no process for " + program.string(), error);
  }
  int error = 0;
  if (::read(*started_.out, &error, sizeof error) == sizeof error) {
    end();
    fail("cannot start " + program.string(), error);
  }
  for (const Descriptor* end : {&input_.in, &output_.out, &errors_.out}) {
    ::fcntl(**end, F_SETFL, O_NONBLOCK);
  }
}

void Process::become(const char* program, char* const* arguments, std::uint64_t bytes) {
  ::setsid();
  // Not the address space, of which virtual machines reserve far more than they touch.
  struct ::rlimit limit = {};
  ::getrlimit(RLIMIT_DATA, &limit);
  limit.rlim_cur = limit.rlim_max = std::min<::rlim_t>(bytes, limit.rlim_max);
  ::setrlimit(RLIMIT_DATA, &limit);
  limit = {0, 0};
  ::setrlimit(RLIMIT_CORE, &limit);
  for (const int signal : {SIGPIPE, SIGXFSZ}) ::signal(signal, SIG_DFL);
  ::sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::dup2(*input_.out, STDIN_FILENO);
  ::dup2(*output_.in, STDOUT_FILENO);
  ::dup2(*errors_.in, STDERR_FILENO);
  ::execv(program, arguments);
  const int error = errno;
  const ::ssize_t written = ::write(*started_.in, &error, sizeof error);
  ::_exit(written > 0 ? 1 : 2);
}

/// A process that ends the program's when this one has ended, however that was.
void Process::guard() {
  ::sigset_t all;
  ::sigfillset(&all);
  ::sigprocmask(SIG_SETMASK, &all, nullptr);
  ::setsid();
  for (const Descriptor* end : {&life_.in, &input_.in, &output_.out, &errors_.out}) ::close(**end);
  char byte = 0;
  while (::read(*life_.out, &byte, 1) < 0 && errno == EINTR) {
  }
  ::kill(-program_, SIGKILL);
  ::_exit(0);
}

void Process::write_some(std::string_view& input) {
  const ::ssize_t written = ::write(*input_.in, input.data(), std::min(input.size(), kAtOnce));
  if (written > 0) input.remove_prefix(static_cast<std::size_t>(written));
  const bool is_closed = written < 0 && errno != EAGAIN && errno != EINTR;
  if (is_closed || input.empty()) input_.in.close();
}

/// Whether there may be more.
bool Process::read_some(Descriptor& from, std::string& into) {
  std::array<char, kAtOnce> block{};
  const ::ssize_t read = ::read(*from, block.data(), block.size());
  if (read > 0) into.append(block.data(), static_cast<std::size_t>(read));
  if (read == 0) from.close();
  if (said_.size() > 2 * kMostSaid) said_.erase(0, said_.size() - kMostSaid);
  if (answer_.size() > kLongestAnswer) {
    throw Error(ErrorCode::Limit, "the answer of a program has more than a gigabyte");
  }
  return read > 0;
}

void Process::say_the_rest() {
  while (errors_.out.is_open() && read_some(errors_.out, said_)) {
  }
}

/// Leaves the process to be waited for, so that its number stays its own.
bool Process::has_ended() const {
  ::siginfo_t info = {};
  return ::waitid(P_PID, static_cast<::id_t>(program_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == program_;
}

bool Process::waits_for_end(double seconds) const {
  const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
  constexpr ::timespec kMoment = {0, 1'000'000};
  while (!has_ended()) {
    if (Clock::now() >= deadline) return false;
    ::nanosleep(&kMoment, nullptr);
  }
  return true;
}

/// Ends the program, what it started, and the guard.
void Process::end() {
  const auto wait_for = [](::pid_t process, int& status) {
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
  };
  if (program_ > 0) {
    ::kill(-program_, SIGKILL);
    ::kill(program_, SIGKILL);  // which may have had no time for a group of its own
    wait_for(std::exchange(program_, -1), status_);
  }
  if (guard_ > 0) {
    int status = 0;
    ::kill(guard_, SIGKILL);
    wait_for(std::exchange(guard_, -1), status);
  }
}

Exchange Process::exchange(std::string_view input, double seconds, Until until) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
  bool is_answered = false, has_time = true, is_there = true;
  std::size_t searched = 0;
  if (input.empty()) input_.in.close();
  while (!is_answered && is_there && has_time) {
    std::array<::pollfd, 3> streams{{{*output_.out, POLLIN, 0},
                                     {*errors_.out, POLLIN, 0},
                                     {*input_.in, POLLOUT, 0}}};  // closed ones are left out
    const bool is_quiet = ::poll(streams.data(), streams.size(), kLook) <= 0;
    if (streams[2].revents != 0) write_some(input);
    if (streams[1].revents != 0) read_some(errors_.out, said_);
    if (streams[0].revents != 0) read_some(output_.out, answer_);
    is_answered = until == Until::Line && answer_.find('\n', searched) != std::string::npos;
    searched = answer_.size();
    // What it started may hold its output open.
    is_there = output_.out.is_open() && !(is_quiet && has_ended());
    has_time = Clock::now() < deadline;
  }
  Exchange result;
  input_.in.close();
  const bool ended = waits_for_end(
      is_answered ? kGoodbye
                  : std::max(0.0, std::chrono::duration<double>(deadline - Clock::now()).count()));
  say_the_rest();
  end();
  result.answer = answer_.substr(0, until == Until::Line ? answer_.find('\n') : answer_.size());
  result.said = said_;
  result.code = WIFSIGNALED(status_) ? WTERMSIG(status_) : WEXITSTATUS(status_);
  using Ending = Exchange::Ending;
  result.ending = is_answered                                        ? Ending::Answered
                  : !ended                                           ? Ending::TimedOut
                  : WIFSIGNALED(status_)                             ? Ending::Signalled
                  : until == Until::End && WEXITSTATUS(status_) == 0 ? Ending::Answered
                                                                     : Ending::Exited;
  return result;
}

}  // namespace

Exchange exchange(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                  std::string_view input, const Limits& limits, Until until) {
  const NoBrokenPipes no_broken_pipes;
  Process process(program, arguments, limits.bytes);
  return process.exchange(input, limits.seconds, until);
}

}  // namespace plumbline::programs

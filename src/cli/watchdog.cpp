// One thread waits for signals, which all others leave to it, and for the time limit.

#include "cli/watchdog.hpp"

#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <initializer_list>

#include "cli/memory_limit.hpp"
#include "cli/terminal.hpp"

namespace plumbline::cli {
namespace {

/// Held while a temporary comes into being or is given up, and for ever by the thread that ends the
/// program. Recursive: memory may run out where it is held.
std::recursive_mutex& mutex() {
  static std::recursive_mutex result;
  return result;
}

const char* temporary = nullptr;  ///< the name of the one that there is

/// Neither allocates nor gives the mutex back: no other thread gets past the end of a file.
void give_up_temporary() {
  mutex().lock();
  if (temporary != nullptr) ::unlink(temporary);
}

void write_error(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void wipe_progress() {
  if (is_screen(stderr)) write_error("\r\033[K");
}

/// Ends as the signal would have ended it, so that a shell's loop ends, too.
[[noreturn]] void end_by(int signal) {
  give_up_temporary();
  wipe_progress();
  ::signal(signal, SIG_DFL);
  ::sigset_t one;
  ::sigemptyset(&one);
  ::sigaddset(&one, signal);
  ::raise(signal);
  ::pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
  constexpr int kEndedBySignal = 128;
  std::_Exit(kEndedBySignal + signal);  // the first process of a container outlives its signals
}

::sigset_t watched_signals() {
  ::sigset_t result;
  ::sigemptyset(&result);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU}) {
    struct ::sigaction action = {};
    ::sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) ::sigaddset(&result, signal);  // nohup
  }
  ::sigaddset(&result, SIGALRM);
  return result;
}

}  // namespace

Watchdog::Watchdog(const Limits& limits) : signals_(watched_signals()) {
  if (limits.seconds) {
    using Clock = std::chrono::steady_clock;
    deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                   std::chrono::duration<double>(*limits.seconds));
    timeout_ = fmt::format("timeout: more than --timeout {:g} seconds", *limits.seconds);
  }
  ::signal(SIGXFSZ, SIG_IGN);  // a file beyond ulimit -f is an error like that of a full disk
  ::pthread_sigmask(SIG_BLOCK, &signals_, &blocked_before_);
  thread_ = std::thread(&Watchdog::watch, this);
  limit_memory(limits);
}

Watchdog::~Watchdog() {
  done_ = true;
  ::pthread_kill(thread_.native_handle(), SIGALRM);
  thread_.join();
  ::pthread_sigmask(SIG_SETMASK, &blocked_before_, nullptr);
}

void Watchdog::watch() {
  using std::chrono::nanoseconds;
  constexpr std::int64_t kSecond = 1'000'000'000;
  while (true) {
    const std::int64_t left =
        !deadline_ ? 0 : nanoseconds(*deadline_ - std::chrono::steady_clock::now()).count();
    if (deadline_ && left <= 0) end_with(timeout_);
    const ::timespec wait = {left / kSecond, left % kSecond};
    const int signal =
        deadline_ ? ::sigtimedwait(&signals_, nullptr, &wait) : ::sigwaitinfo(&signals_, nullptr);
    if (signal == SIGALRM && done_) return;
    if (signal > 0) end_by(signal);
  }
}

void end_with(std::string_view error) {
  give_up_temporary();
  wipe_progress();
  write_error("plumbline: ");
  write_error(error);
  write_error("\n");
  std::_Exit(kBadInput);
}

WatchedFile::WatchedFile(const std::string& name) : lock_(mutex()), file_(name) {
  if (!file_.temporary().empty()) temporary = file_.temporary().c_str();
  lock_.unlock();
}

WatchedFile::~WatchedFile() {
  lock_.lock();
  temporary = nullptr;
}

}  // namespace plumbline::cli

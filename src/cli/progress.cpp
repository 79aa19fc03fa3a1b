#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>

#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

std::string bar_of(double part) {
  constexpr int kWidth = 30;
  const auto full = static_cast<std::size_t>(part * kWidth);
  return "[" + std::string(full, '#') + std::string(kWidth - full, '.') + "]";
}

}  // namespace

Progress::Progress(std::string_view what) : what_(line_text(what)) {
  if (::isatty(STDERR_FILENO) != 0) thread_ = std::thread(&Progress::show, this);
}

Progress::~Progress() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Progress::show() {
  constexpr std::chrono::seconds kPatience(2), kStep(1);
  std::unique_lock lock(mutex_);
  if (changed_.wait_for(lock, kPatience, [this] { return done_; })) return;
  for (auto seconds = kPatience; !done_; seconds += kStep) {
    const double part = part_;
    const std::string bar =
        part < 0 ? " ..." : fmt::format(" {} {:2.0f} %", bar_of(part), 100 * part);
    fmt::print(stderr, "\r{}{} {} s", what_, bar, seconds.count());
    std::fflush(stderr);
    changed_.wait_for(lock, kStep, [this] { return done_; });
  }
  fmt::print(stderr, "\r\033[K");
}

}  // namespace plumbline::cli

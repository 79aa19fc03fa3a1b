#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <utility>

namespace plumbline::cli {

Progress::Progress(std::string what) : what_(std::move(what)) {
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
    fmt::print(stderr, "\r{} ... {} s", what_, seconds.count());
    std::fflush(stderr);
    changed_.wait_for(lock, kStep, [this] { return done_; });
  }
  fmt::print(stderr, "\r\033[K");
}

}  // namespace plumbline::cli

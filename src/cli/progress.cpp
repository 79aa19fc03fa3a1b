#include "cli/progress.hpp"

#include <fmt/format.h>

#include "cli/terminal.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

/// " [####....]  50 %"; what follows the last per cent has none.
std::string bar_of(double part) {
  constexpr int kWidth = 30;
  constexpr double kDone = 0.995;  // what rounds to 100 %
  if (part < 0) return " ...";
  if (part >= kDone) return ", nearly done";
  const auto full = static_cast<std::size_t>(part * kWidth);
  return fmt::format(" [{}{}] {:2.0f} %", std::string(full, '#'), std::string(kWidth - full, '.'),
                     100 * part);
}

}  // namespace

Progress::Progress(std::string_view what, const Manners& manners)
    : what_(line_text(what)), is_verbose_(manners.verbose) {
  if (!manners.quiet && is_screen(stderr)) thread_ = std::thread(&Progress::show, this);
}

Progress::~Progress() {
  if (thread_.joinable()) {
    {
      const std::lock_guard lock(mutex_);
      done_ = true;
    }
    changed_.notify_one();
    thread_.join();
  }
  if (!is_verbose_) return;
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin_;
  fmt::print(stderr, "{:9.3f} s  {}\n", time.count(), what_);
}

void Progress::show() {
  constexpr std::chrono::seconds kPatience(2), kStep(1);
  std::unique_lock lock(mutex_);
  if (changed_.wait_for(lock, kPatience, [this] { return done_; })) return;
  std::size_t shown = 0;
  for (auto seconds = kPatience; !done_; seconds += kStep) {
    const std::string line = cut(fmt::format("{}{} {} s", what_, bar_of(part_), seconds.count()),
                                 columns_of(stderr) - 1);
    const std::size_t width = width_of(line);
    // Blanks wipe what a longer line has left: every terminal knows them.
    fmt::print(stderr, "\r{}{}", line, std::string(shown > width ? shown - width : 0, ' '));
    std::fflush(stderr);
    shown = width;
    changed_.wait_for(lock, kStep, [this] { return done_; });
  }
  fmt::print(stderr, "\r{}\r", std::string(shown, ' '));
}

}  // namespace plumbline::cli

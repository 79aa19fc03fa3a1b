#include "cli/progress.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/terminal.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

/// "arranging [####....]  50 % 12 s" in so many columns: without a bar where there is no room for
/// one. After the last per cent comes what nobody counts.
std::string line_of(const std::string& what, double part, std::int64_t seconds,
                    std::size_t columns) {
  constexpr std::size_t kLeast = 5, kMost = 30;
  constexpr double kDone = 0.995;  // what rounds to 100 %
  if (part < 0) return cut(fmt::format("{} ... {} s", what, seconds), columns);
  if (part >= kDone) return cut(fmt::format("{}, finishing ... {} s", what, seconds), columns);
  const std::string told = fmt::format(" {:2.0f} % {} s", 100 * part, seconds);
  const std::size_t used = width_of(what) + told.size() + 3;
  if (columns < used + kLeast) {
    return cut(what, columns - std::min(columns, told.size())) + told;
  }
  const std::size_t width = std::min(kMost, columns - used);
  const auto full = static_cast<std::size_t>(part * static_cast<double>(width));
  return fmt::format("{} [{}{}]{}", what, std::string(full, '#'), std::string(width - full, '.'),
                     told);
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

void Progress::tell(std::string_view what) {
  std::string line = line_text(what);
  const std::lock_guard lock(mutex_);
  what_ = std::move(line);
}

void Progress::show() {
  constexpr std::chrono::seconds kPatience(2), kStep(1);
  std::unique_lock lock(mutex_);
  if (changed_.wait_for(lock, kPatience, [this] { return done_; })) return;
  std::size_t shown = 0;
  for (auto seconds = kPatience; !done_; seconds += kStep) {
    const std::string line = line_of(what_, part_, seconds.count(), columns_of(stderr) - 1);
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

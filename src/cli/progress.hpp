#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "cli/commands.hpp"

namespace plumbline::cli {

/// Shows on standard error what is being done and for how long, once it takes over two seconds;
/// only if that is a terminal that obeys, and nobody asked for quiet. Wipes its line when it ends,
/// and says how long it took where manners are verbose.
class Progress {
 public:
  Progress(std::string_view what, const Manners& manners);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Which part of the work is done, from 0 to 1: shown as a bar. What comes after 1 is the rest.
  void tell(double part) { part_ = part; }
  /// What is being done now.
  void tell(std::string_view what);

 private:
  void show();

  std::string what_;
  bool is_verbose_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::atomic<double> part_ = -1;  ///< negative: not told
  std::mutex mutex_;
  std::condition_variable changed_;
  bool done_ = false;
  std::thread thread_;
};

}  // namespace plumbline::cli

#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace plumbline::cli {

/// Shows on standard error what is being done and for how long, once it takes over two seconds;
/// only if standard error is a terminal. Wipes its line when it ends.
class Progress {
 public:
  explicit Progress(std::string_view what);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Which part of the work is done, from 0 to 1: shown as a bar.
  void tell(double part) { part_ = part; }

 private:
  void show();

  std::string what_;
  std::atomic<double> part_ = -1;  ///< negative: not told
  std::mutex mutex_;
  std::condition_variable changed_;
  bool done_ = false;
  std::thread thread_;
};

}  // namespace plumbline::cli

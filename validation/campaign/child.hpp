#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

namespace plumbline::campaign {

/// Runs `work` in a child process, so that whatever happens there is only a result here.
/// Requires: the calling process has one thread. Memory of a child is limited to 4 GB,
/// but not with sanitizers.
class Child {
 public:
  /// What `work` returns is for `outcome`.
  explicit Child(const std::function<std::string()>& work);
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();  ///< ends the child if it still runs

  /// Waits so long at most; whether the child has ended.
  bool ended_within(double seconds);
  void end();
  /// What the work returned, "throws ...", "crash (signal 11)", or "hang" if it was ended.
  /// Requires: it has ended.
  const std::string& outcome() const { return outcome_; }

 private:
  void collect(int status);

  pid_t pid_;
  int pipe_ = -1;  ///< its end to read from
  bool has_ended_ = false;
  std::string outcome_;
};

/// The outcome of work in a child that gets so many seconds.
std::string in_child(const std::function<std::string()>& work, double seconds);

}  // namespace plumbline::campaign

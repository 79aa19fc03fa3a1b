#pragma once

// Stands in for oneTBB's header in builds with the thread sanitizer, see README.md.

namespace tbb {

/// How many threads the parallel algorithms called by this thread use.
inline thread_local int stand_in_threads = 2;

class task_arena {
 public:
  explicit task_arena(int threads) : threads_(threads) {}

  template <class Work>
  auto execute(Work work) const {
    struct Restore {
      int threads = stand_in_threads;
      ~Restore() { stand_in_threads = threads; }
    } const restore;
    stand_in_threads = threads_;
    return work();
  }

 private:
  int threads_;
};

}  // namespace tbb

#pragma once

// Stands in for oneTBB's header in builds with the thread sanitizer, see README.md.

#include <tbb/task_arena.h>

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb {

/// Calls work(i) for begin <= i < end, on the calling thread and on new ones, which end before it
/// returns. Threads take indices without ordering anything else by it: what two calls of `work`
/// share, they must order themselves, as with oneTBB. Throws: what the first call to fail throws.
template <class Index, class Work>
void parallel_for(Index begin, Index end, const Work& work) {
  std::atomic<Index> next{begin};
  std::mutex failing;
  std::exception_ptr failure;
  const auto take = [&] {
    try {
      for (Index i; (i = next.fetch_add(1, std::memory_order_relaxed)) < end;) work(i);
    } catch (...) {
      next.store(end, std::memory_order_relaxed);
      const std::lock_guard lock(failing);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (int t = 1; t < stand_in_threads; ++t) others.emplace_back(take);
    take();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace tbb

#include "engines/lar/stages/parallel.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <optional>
#include <thread>

namespace plumbline::lar {

void on_threads(std::size_t threads, const std::function<void()>& work) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t most = std::min(threads == 0 ? cores : threads, kMostThreads);
  // Without this, TBB warns and starts no more threads than there are cores.
  std::optional<tbb::global_control> more;
  if (most > static_cast<std::size_t>(tbb::info::default_concurrency())) {
    more.emplace(tbb::global_control::max_allowed_parallelism, most);
  }
  tbb::task_arena(static_cast<int>(most)).execute(work);
}

}  // namespace plumbline::lar

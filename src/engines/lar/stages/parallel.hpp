#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <functional>

namespace plumbline::lar {

/// Calls work(); `for_blocks` in it uses at most that many threads (and kMostThreads; 0: as many as
/// there are cores).
void on_threads(std::size_t threads, const std::function<void()>& work);
inline constexpr std::size_t kMostThreads = 1024;

/// Calls work(begin, end) for blocks of at most `size` indices below `count`, in parallel and in no
/// order. Blocks do not depend on the number of threads. Requires: no work of two blocks on the
/// same object.
template <class Work>
void for_blocks(std::size_t count, std::size_t size, const Work& work) {
  const std::size_t blocks = (count + size - 1) / size;
  const auto one = [&](std::size_t block) {
    work(block * size, std::min(count, (block + 1) * size));
  };
  if (blocks == 1) return one(0);
  tbb::parallel_for(std::size_t{0}, blocks, one);
}

}  // namespace plumbline::lar

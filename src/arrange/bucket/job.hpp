#pragma once

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <utility>
#include <vector>

#include "arrange/bucket/types.hpp"

namespace plumbline::bucket {

/// Lists longer than this are refused: halfedges, twice as many as edges, are numbered in 32 bits.
inline constexpr std::uint64_t kMostItems = (std::uint64_t{1} << 31U) - 1;
/// Throws: Error Limit.
[[noreturn]] void throw_too_many();

/// Lines that are worth a task: some have thousands of meetings.
inline constexpr std::size_t kLinesPerTask = 64;

/// Runs the steps of one arrangement: on how many threads, who is told, and whether to stop. Work
/// is cut into blocks of a size that does not depend on the number of threads.
class Job {
 public:
  /// `threads`: at least 1. `progress`: may be empty; returning false cancels.
  Job(std::size_t threads, std::function<bool(double)> progress);

  std::size_t threads() const { return threads_; }
  bool is_parallel() const { return threads_ > 1; }

  /// The next step takes about this share of the whole job. Throws: Error Cancelled.
  void begin_step(double share);

  /// Calls work(begin, end) for blocks of at most `size` indices below `count`.
  template <class Work>
  void for_blocks(std::size_t count, std::size_t size, Work work) {
    const std::size_t blocks = (count + size - 1) / size;
    std::atomic<std::size_t> done = 0;
    const auto one = [&](std::size_t block) {
      work(block * size, std::min(count, (block + 1) * size));
      tell(static_cast<double>(done.fetch_add(1, std::memory_order_relaxed) + 1) /
           static_cast<double>(blocks));
    };
    if (is_parallel() && blocks > 1) {
      tbb::parallel_for(std::size_t{0}, blocks, one);
    } else {
      for (std::size_t block = 0; block < blocks; ++block) one(block);
    }
  }
  /// Calls work(i) for each index below `count`; `block` of them are worth a task.
  template <class Work>
  void for_each(std::size_t count, Work work, std::size_t block = 4096) {
    for_blocks(count, block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) work(i);
    });
  }

  /// Sorts by a total order, so that the result does not depend on the algorithm.
  template <class Range, class Less>
  void sort(Range& range, Less less) {
    if (is_parallel()) {
      tbb::parallel_sort(range.begin(), range.end(), less);
    } else {
      std::sort(range.begin(), range.end(), less);
    }
  }

  void sort_integers(std::vector<std::uint64_t>& values) const;

  /// Adds 1 to a counter that other threads may be adding to; the value before.
  std::uint32_t increment(std::uint32_t& counter) const {
    if (!is_parallel()) return counter++;
    return std::atomic_ref(counter).fetch_add(1, std::memory_order_relaxed);
  }

 private:
  void tell(double done_of_step);

  std::size_t threads_;
  std::function<bool(double)> progress_;
  std::thread::id caller_;
  double done_ = 0, share_ = 0, told_ = 0;
};

/// Turns counts into begins: values[i] becomes the sum of those before i; the total is appended.
/// Throws: Error Limit where the total does not fit.
template <class Value>
void accumulate(std::vector<Value>& values) {
  std::uint64_t sum = 0;
  for (Value& v : values) {
    const Value count = v;
    v = static_cast<Value>(sum);
    sum += count;
  }
  if (sum > kMostItems && sizeof(Value) < sizeof sum) throw_too_many();
  values.push_back(static_cast<Value>(sum));
}

/// Sorts items by key: list k has those of key k, in their order. `for_items(begin, end, visit)`
/// calls visit(key, item) for the items of a range of blocks, the same each time.
template <class Item, class ForItems>
Grouped<Item> group(std::size_t key_count, std::size_t block_count, const ForItems& for_items,
                    Job& job) {
  // A range for each thread, with counters of its own.
  const std::size_t ranges = std::max<std::size_t>(1, std::min(job.threads(), block_count));
  const auto first = [&](std::size_t range) { return range * block_count / ranges; };
  std::vector<std::vector<std::uint32_t>> next(ranges);
  job.for_each(
      ranges,
      [&](std::size_t r) {
        next[r].assign(key_count, 0);
        for_items(first(r), first(r + 1), [&](std::size_t key, const Item&) { ++next[r][key]; });
      },
      1);
  Grouped<Item> result;
  result.begin.assign(key_count, 0);
  for (const auto& counts : next) {
    for (std::size_t k = 0; k < key_count; ++k) result.begin[k] += counts[k];
  }
  accumulate(result.begin);
  for (std::size_t k = 0; k < key_count; ++k) {
    std::uint32_t at = result.begin[k];
    for (auto& counts : next) at += std::exchange(counts[k], at);
  }
  result.items.resize(result.begin.back());
  job.for_each(
      ranges,
      [&](std::size_t r) {
        for_items(first(r), first(r + 1),
                  [&](std::size_t key, const Item& item) { result.items[next[r][key]++] = item; });
      },
      1);
  return result;
}

}  // namespace plumbline::bucket

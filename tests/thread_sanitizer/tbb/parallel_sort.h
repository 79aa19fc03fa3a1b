#pragma once

// Stands in for oneTBB's header in builds with the thread sanitizer, see README.md.

#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>

namespace tbb {

/// Sorts both halves at once, then merges them.
template <class Iterator, class Less = std::less<>>
void parallel_sort(Iterator begin, Iterator end, Less less = {}) {
  const Iterator middle = begin + (end - begin) / 2;
  parallel_for(0, 2, [&](int half) {
    half == 0 ? std::sort(begin, middle, less) : std::sort(middle, end, less);
  });
  std::inplace_merge(begin, middle, end, less);
}

}  // namespace tbb

#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace plumbline {

/// Disjoint sets of 0..n-1. Each is represented by its least member, unless `unite_into` chose
/// another one. For one thread: the bucket engine, whose threads unite at the same time, has a
/// lock-free one of its own. **Requires**: n < 2^32. **Cost**: O(log n) a call, amortised.
class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }

  /// The member that represents the set of i.
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];  // halves the way for later calls
      i = parent_[i];
    }
    return i;
  }

  /// Makes the sets of i and j one, represented by the lesser of their representatives.
  void unite(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    if (i < j) {
      parent_[j] = static_cast<std::uint32_t>(i);
    } else {
      parent_[i] = static_cast<std::uint32_t>(j);
    }
  }

  /// Makes the sets of i and j one, represented by the representative of i.
  void unite_into(std::size_t i, std::size_t j) {
    parent_[find(j)] = static_cast<std::uint32_t>(find(i));
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace plumbline

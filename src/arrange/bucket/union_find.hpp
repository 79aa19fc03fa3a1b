#pragma once

#include <atomic>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace plumbline::bucket {

/// Disjoint sets of numbers, each represented by its least member. It is not that of `geometry`
/// because several threads may unite and find in it at the same time: a root is linked under a
/// lesser one by compare-and-swap (Anderson and Woll, "Wait-free parallel algorithms for the
/// union-find problem", 1991), so the sets and their representatives do not depend on the order.
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  /// The first sets are given: per member their least one.
  UnionFind(const std::vector<std::uint32_t>& least, std::size_t count) : parent_(least) {
    parent_.resize(count);
    std::iota(parent_.begin() + static_cast<std::ptrdiff_t>(least.size()), parent_.end(),
              static_cast<std::uint32_t>(least.size()));
  }

  std::size_t size() const { return parent_.size(); }

  std::uint32_t find(std::uint32_t i) const {
    while (true) {
      const std::uint32_t up = load(i);
      if (up == i) return i;
      const std::uint32_t top = load(up);
      if (top != up) std::atomic_ref(parent_[i]).store(top, std::memory_order_relaxed);
      i = top;
    }
  }

  void unite(std::uint32_t i, std::uint32_t j) {
    while (true) {
      i = find(i);
      j = find(j);
      if (i == j) return;
      if (i < j) std::swap(i, j);
      std::uint32_t root = i;
      if (std::atomic_ref(parent_[i]).compare_exchange_strong(root, j, std::memory_order_relaxed)) {
        return;
      }
    }
  }

 private:
  std::uint32_t load(std::uint32_t i) const {
    return std::atomic_ref(parent_[i]).load(std::memory_order_relaxed);
  }

  mutable std::vector<std::uint32_t>
      parent_;  ///< never greater than the member; find shortens paths
};

}  // namespace plumbline::bucket

#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace plumbline::lar {

/// Disjoint sets of 0..n-1, each represented by its least member.
class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    (i < j ? parent_[j] : parent_[i]) = i < j ? i : j;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace plumbline::lar

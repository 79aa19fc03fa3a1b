#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumbline/engines/lar.hpp"

namespace plumbline::lar {

/// The pairs of edges that share a bucket, each in one place: the first bucket that holds both. Cut
/// into tasks that do not depend on each other. Keeps a reference to the buckets.
class BucketPairs {
 public:
  BucketPairs(std::size_t edges, const Lists<EdgeId>& buckets);

  /// Neighbouring members of a bucket, each to be paired with those behind it.
  struct Rows {
    std::uint32_t bucket;
    std::uint32_t begin, end;
  };
  std::size_t task_count() const { return task_begin_.size() - 1; }
  /// Whole buckets, or some rows of full ones. How rows are cut depends on the buckets alone.
  std::span<const Rows> task(std::size_t i) const {
    return std::span(rows_).subspan(task_begin_[i], task_begin_[i + 1] - task_begin_[i]);
  }
  std::span<const EdgeId> bucket(std::uint32_t b) const { return buckets_[b]; }
  /// Whether no bucket before this one holds both edges. Requires: this one does.
  bool is_first_common(std::uint32_t bucket, EdgeId s, EdgeId t) const {
    const auto of_s = buckets_of(s), of_t = buckets_of(t);
    auto i = of_s.begin(), j = of_t.begin();
    while (*i != *j) ++(*i < *j ? i : j);
    return *i == bucket;
  }

 private:
  std::span<const std::uint32_t> buckets_of(EdgeId e) const {
    return std::span(buckets_of_).subspan(begin_[e], begin_[e + 1] - begin_[e]);
  }

  const Lists<EdgeId>& buckets_;
  std::vector<Rows> rows_;
  std::vector<std::size_t> task_begin_;
  std::vector<std::size_t> begin_;         ///< per edge, in the next list
  std::vector<std::uint32_t> buckets_of_;  ///< ascending
};

}  // namespace plumbline::lar

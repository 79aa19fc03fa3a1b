#include "engines/lar/stages/bucket_pairs.hpp"

namespace plumbline::lar {
namespace {

/// Half a millisecond of work, large beside starting a task.
constexpr std::size_t kLeastPairs = std::size_t{1} << 14U;
/// A task may find a place on every member of a full bucket that it has rows of: so many rows keep
/// that small beside its pairs.
constexpr std::size_t kLeastRows = 64;

}  // namespace

BucketPairs::BucketPairs(std::size_t edges, const Lists<EdgeId>& buckets)
    : buckets_(buckets), task_begin_{0}, begin_(edges + 1, 0) {
  for (const EdgeId e : buckets.flat()) ++begin_[e + 1];
  for (std::size_t e = 0; e < edges; ++e) begin_[e + 1] += begin_[e];
  buckets_of_.resize(buckets.flat().size());
  std::vector<std::size_t> next = begin_;
  std::size_t rows = 0, pairs = 0;  // of the task so far
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    const auto number = static_cast<std::uint32_t>(b);
    const auto members = buckets[b];
    rows_.push_back({number, 0, 0});
    for (std::size_t i = 0; i < members.size(); ++i) {
      buckets_of_[next[members[i]]++] = number;
      ++rows_.back().end;
      pairs += members.size() - 1 - i;
      if (++rows < kLeastRows || pairs < kLeastPairs) continue;
      rows = pairs = 0;
      task_begin_.push_back(rows_.size());
      rows_.push_back({number, rows_.back().end, rows_.back().end});
    }
  }
  if (task_begin_.back() < rows_.size()) task_begin_.push_back(rows_.size());
}

}  // namespace plumbline::lar

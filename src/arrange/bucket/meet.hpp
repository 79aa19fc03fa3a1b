#pragma once

// Step 4: what meets in each bucket. Brute force over the pairs of lines in a bucket; in a full
// one, lines are first sorted across their common direction, and those that go through one point
// are recognised together.

#include <algorithm>

#include "arrange/bucket/pencils.hpp"

namespace plumbline::bucket {

/// The ends in this bucket by their points, then by number.
template <class Kernel>
std::vector<EndId> sorted_ends(const Scene<Kernel>& scene, std::size_t bucket) {
  std::vector<EndId> ends;
  const Membership here(scene.buckets, bucket);
  for (const LineId s : scene.buckets.lines(bucket)) {
    for (const EndId e : {first_end(s), last_end(s)}) {
      if (here.contains(scene.place(e))) ends.push_back(e);
    }
  }
  std::sort(ends.begin(), ends.end(), [&](EndId p, EndId q) {
    const int c = scene.kernel.compare(p, q);
    return c != 0 ? c < 0 : p < q;
  });
  return ends;
}

template <class Kernel>
void search_bucket(const Scene<Kernel>& scene, std::size_t bucket, Meetings& found) {
  const std::span<const LineId> lines = scene.buckets.lines(bucket);
  if (lines.size() > kFullBucket) {
    Pencils<Kernel>(scene, bucket, found).search(lines);
    return;
  }
  Pairs<Kernel> pairs(scene, bucket, found);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = i + 1; j < lines.size(); ++j) pairs.test(lines[i], lines[j]);
  }
}

/// Ranges of buckets of about equal work.
inline std::vector<std::size_t> balanced_blocks(const Buckets& buckets) {
  constexpr std::size_t kWork = 4096;
  std::vector<std::size_t> begin{0};
  std::size_t work = 0;
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    const std::size_t lines = buckets.lines(b).size();
    work += 1 + lines + lines * lines / 4;
    if (work >= kWork || b + 1 == buckets.size()) {
      begin.push_back(b + 1);
      work = 0;
    }
  }
  return begin;
}

/// Per end the least of the ends at the same point. They are in one bucket, so blocks of buckets
/// write about different ends.
template <class Kernel>
std::vector<EndId> same_ends(const Scene<Kernel>& scene, Job& job) {
  std::vector<EndId> same(2 * scene.kernel.size());
  std::iota(same.begin(), same.end(), 0U);
  const std::vector<std::size_t> begin = balanced_blocks(scene.buckets);
  job.for_blocks(begin.size() - 1, 1, [&](std::size_t block, std::size_t) {
    for (std::size_t b = begin[block]; b < begin[block + 1]; ++b) {
      const std::vector<EndId> ends = sorted_ends(scene, b);
      for (std::size_t i = 1; i < ends.size(); ++i) {
        if (scene.kernel.compare(ends[i - 1], ends[i]) == 0) same[ends[i]] = same[ends[i - 1]];
      }
    }
  });
  return same;
}

/// Searches all buckets; one Meetings per block of buckets.
template <class Kernel>
std::vector<Meetings> find_meetings(const Scene<Kernel>& scene, Job& job) {
  const std::vector<std::size_t> begin = balanced_blocks(scene.buckets);
  std::vector<Meetings> found(begin.size() - 1);
  job.for_blocks(found.size(), 1, [&](std::size_t block, std::size_t) {
    for (std::size_t b = begin[block]; b < begin[block + 1]; ++b) {
      search_bucket(scene, b, found[block]);
    }
  });
  return found;
}

}  // namespace plumbline::bucket

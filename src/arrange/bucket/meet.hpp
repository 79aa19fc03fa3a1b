#pragma once

// Step 4: what meets in each bucket. Brute force over the pairs of lines in a bucket; in a full
// one, lines are first sorted across their common direction, and those that go through one point
// are recognised together.

#include <algorithm>

#include "arrange/bucket/pencils.hpp"

namespace plumbline::bucket {

/// Finds out which of the ends in this bucket are the same point.
template <class Kernel>
void join_ends(const Scene<Kernel>& scene, std::size_t bucket, std::vector<EndId>& ends) {
  ends.clear();
  for (const LineId s : scene.buckets.lines(bucket)) {
    for (const EndId e : {first_end(s), last_end(s)}) {
      const PointD p = scene.place(e);
      if (scene.buckets.bucket_at(p.x, p.y) == bucket) ends.push_back(e);
    }
  }
  if (ends.size() < 2) return;
  std::sort(ends.begin(), ends.end(), [&](EndId p, EndId q) {
    const int c = scene.kernel.compare(p, q);
    return c != 0 ? c < 0 : p < q;
  });
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (scene.kernel.compare(ends[i - 1], ends[i]) == 0) {
      scene.same_end[ends[i]] = scene.same_end[ends[i - 1]];
    }
  }
}

template <class Kernel>
void search_bucket(const Scene<Kernel>& scene, std::size_t bucket, Meetings& found) {
  constexpr std::size_t kFew = 24;
  const std::span<const LineId> lines = scene.buckets.lines(bucket);
  if (lines.size() > kFew) {
    Pencils<Kernel>(scene, bucket, found).search(lines);
    return;
  }
  Pairs<Kernel> pairs(scene, bucket, found);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = i + 1; j < lines.size(); ++j) pairs.test(lines[i], lines[j]);
  }
}

/// Searches all buckets; one Meetings per block of buckets.
template <class Kernel>
std::vector<Meetings> find_meetings(const Scene<Kernel>& scene, Job& job) {
  constexpr std::size_t kBlock = 512;
  std::vector<Meetings> found((scene.buckets.size() + kBlock - 1) / kBlock);
  job.for_blocks(scene.buckets.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    std::vector<EndId> ends;
    for (std::size_t b = begin; b < end; ++b) {
      join_ends(scene, b, ends);
      search_bucket(scene, b, found[begin / kBlock]);
    }
  });
  return found;
}

}  // namespace plumbline::bucket

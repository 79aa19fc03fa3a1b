// Threshold splitting of boxes, with the original's stopping rule.

#include <algorithm>
#include <set>
#include <utility>

#include "engines/inters/stages/fail.hpp"
#include "engines/lar/stages/threshold.hpp"
#include "plumbline/engines/inters_stages.hpp"
#include "plumbline/error.hpp"

namespace plumbline::inters {
namespace {

using lar::Bucket;
using lar::centroid;
using lar::Halves;

constexpr std::size_t kSmallBucket = 4;
constexpr std::size_t kLeastDrop = 7;

[[noreturn]] void throw_too_many() {
  throw Error(ErrorCode::Limit, "the published buckets repeat the segments without bound");
}

Halves split_on_threshold(std::span<const Box> boxes, const Bucket& bucket, std::size_t axis) {
  if (bucket.empty()) fail("IndexError", "list index out of range", "centroid");
  return lar::split_on_threshold(boxes, bucket, axis, centroid(boxes, bucket, axis));
}

/// Final and pending buckets (splitting).
class Splitting {
 public:
  Splitting(Bucket all, std::size_t max_members) : max_members_(max_members) {
    pending_.push_back(std::move(all));
  }

  bool done() const { return pending_.empty(); }
  Bucket pop() {
    Bucket bucket = std::move(pending_.back());
    pending_.pop_back();
    return bucket;
  }
  void add(std::size_t members, Halves halves) {
    const std::size_t below = halves.below.size(), above = halves.above.size();
    const bool is_final = (below < kSmallBucket && above < kSmallBucket) ||
                          members - below < kLeastDrop || members - above < kLeastDrop;
    members_ += below + above;
    if (members_ > max_members_) throw_too_many();
    for (Bucket* half : {&halves.below, &halves.above}) {
      if (is_final) {
        final_.insert(std::move(*half));
      } else {
        pending_.push_back(std::move(*half));
      }
    }
  }
  const std::set<Bucket>& final_buckets() const { return final_; }

 private:
  std::vector<Bucket> pending_;
  std::set<Bucket> final_;
  std::size_t max_members_;
  std::size_t members_ = 0;
};

/// Per box the union of its buckets, without itself (geomPartitionate).
Lists<SegmentId> partners(std::size_t boxes, const std::set<Bucket>& buckets,
                          std::size_t max_members) {
  std::vector<std::vector<const Bucket*>> buckets_of(boxes);
  for (const Bucket& bucket : buckets) {
    for (const EdgeId e : bucket) buckets_of[e].push_back(&bucket);
  }
  Lists<SegmentId> result;
  std::vector<SegmentId> others;
  std::vector<std::size_t> seen_by(boxes, boxes);
  for (std::size_t i = 0; i < boxes; ++i) {
    others.clear();
    seen_by[i] = i;
    for (const Bucket* bucket : buckets_of[i]) {
      for (const EdgeId e : *bucket) {
        if (std::exchange(seen_by[e], i) != i) others.emplace_back(e);
      }
    }
    std::sort(others.begin(), others.end());
    if (result.flat().size() + others.size() > max_members) throw_too_many();
    result.push_back(others);
  }
  return result;
}

}  // namespace

Lists<SegmentId> box_buckets(std::span<const Box> boxes, std::size_t max_members) {
  Bucket all;
  for (std::size_t i = 0; i < boxes.size(); ++i) all.emplace_back(i);
  Splitting splitting(std::move(all), max_members);
  while (!splitting.done()) {
    const Bucket bucket = splitting.pop();
    const Halves in_y = split_on_threshold(boxes, bucket, 1);
    Halves above = split_on_threshold(boxes, in_y.above, 0);
    Halves below = split_on_threshold(boxes, in_y.below, 0);
    splitting.add(in_y.above.size(), std::move(above));
    splitting.add(in_y.below.size(), std::move(below));
  }
  return partners(boxes.size(), splitting.final_buckets(), max_members);
}

}  // namespace plumbline::inters

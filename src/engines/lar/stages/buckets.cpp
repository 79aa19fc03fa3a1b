// Threshold splitting of boxes into buckets. Every split that is made shrinks both halves by a
// quarter and repeats at most a third of the members, so depth is logarithmic and the halves' total
// stays far below the number of pairs.

#include <algorithm>
#include <numeric>
#include <optional>

#include "engines/lar/stages/threshold.hpp"
#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {
namespace {

constexpr std::size_t kSmallBucket = 4;  ///< published: fewer members are not split
constexpr std::size_t kLeastDrop = 7;    ///< published: a half must have this many members less

double center(const Box& box, std::size_t axis) { return box[axis] / 2 + box[axis + 2] / 2; }

double median(std::span<const Box> boxes, const Bucket& bucket, std::size_t axis) {
  std::vector<double> centers;
  for (EdgeId e : bucket) centers.push_back(center(boxes[e], axis));
  const auto middle = centers.begin() + static_cast<std::ptrdiff_t>(centers.size() / 2);
  std::nth_element(centers.begin(), middle, centers.end());
  return *middle;
}

bool pays(const Halves& halves, std::size_t members) {
  const std::size_t larger = std::max(halves.below.size(), halves.above.size());
  const std::size_t repeated = halves.below.size() + halves.above.size() - members;
  return larger + std::max(kLeastDrop, members / 4) <= members && repeated <= members / 3;
}

std::optional<Halves> split(std::span<const Box> boxes, const Bucket& bucket, std::size_t axis) {
  for (const auto threshold : {centroid, median}) {
    Halves halves = split_on_threshold(boxes, bucket, axis, threshold(boxes, bucket, axis));
    if (pays(halves, bucket.size())) return halves;
  }
  return std::nullopt;
}

}  // namespace

Lists<EdgeId> box_buckets(std::span<const Box> boxes) {
  struct Pending {
    Bucket bucket;
    std::size_t axis;
  };
  Bucket all;
  for (std::size_t i = 0; i < boxes.size(); ++i) all.push_back(EdgeId(i));
  std::vector<Pending> stack;
  stack.push_back({std::move(all), 1});
  std::vector<Bucket> final_buckets;
  while (!stack.empty()) {
    const Pending pending = std::move(stack.back());
    stack.pop_back();
    std::optional<Halves> halves;
    std::size_t axis = pending.axis;
    if (pending.bucket.size() >= kSmallBucket) {
      halves = split(boxes, pending.bucket, axis);
      if (!halves) halves = split(boxes, pending.bucket, axis = 1 - axis);
    }
    if (halves) {
      stack.push_back({std::move(halves->below), 1 - axis});
      stack.push_back({std::move(halves->above), 1 - axis});
    } else if (pending.bucket.size() > 1) {
      final_buckets.push_back(pending.bucket);
    }
  }
  std::sort(final_buckets.begin(), final_buckets.end());
  final_buckets.erase(std::unique(final_buckets.begin(), final_buckets.end()), final_buckets.end());
  Lists<EdgeId> buckets;
  for (const Bucket& bucket : final_buckets) buckets.push_back(bucket);
  return buckets;
}

}  // namespace plumbline::lar

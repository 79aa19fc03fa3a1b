#include "engines/lar/stages/threshold.hpp"

namespace plumbline::lar {

double centroid(std::span<const Box> boxes, const Bucket& bucket, std::size_t axis) {
  double sum = 0;
  for (const EdgeId e : bucket) sum += (boxes[e][axis] + boxes[e][axis + 2]) / 2;
  return sum / static_cast<double>(bucket.size());
}

Halves split_on_threshold(std::span<const Box> boxes, const Bucket& bucket, std::size_t axis,
                          double threshold) {
  Halves halves;
  for (const EdgeId e : bucket) {
    if (boxes[e][axis] <= threshold) halves.below.push_back(e);
    if (boxes[e][axis + 2] >= threshold) halves.above.push_back(e);
  }
  return halves;
}

}  // namespace plumbline::lar

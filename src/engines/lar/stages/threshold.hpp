#pragma once

#include <span>
#include <vector>

#include "plumbline/engines/lar.hpp"

namespace plumbline::lar {

/// Boxes that will be tested against each other, ascending.
using Bucket = std::vector<EdgeId>;

struct Halves {
  Bucket below;
  Bucket above;
};

/// The mean of the boxes' centres along an axis (0: x, 1: y). Requires: a bucket that is not empty.
/// Section 2.1 and appendix (centroid).
double centroid(std::span<const Box> boxes, const Bucket& bucket, std::size_t axis);

/// The boxes that reach below and above the threshold along the axis; those on it are in both.
/// Section 2.1 (splitOnThreshold).
Halves split_on_threshold(std::span<const Box> boxes, const Bucket& bucket, std::size_t axis,
                          double threshold);

}  // namespace plumbline::lar

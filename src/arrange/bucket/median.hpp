#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace plumbline::bucket {

/// The median of a sample of values; `at(i)` gives each. Requires: count > 0.
template <class Value, class At>
Value median_of(std::size_t count, At at) {
  constexpr std::size_t kSample = 1024;
  std::vector<Value> sample;
  const std::size_t size = std::min(count, kSample);
  for (std::size_t i = 0; i < size; ++i) sample.push_back(at(i * count / size));
  std::nth_element(sample.begin(), sample.begin() + static_cast<std::ptrdiff_t>(size / 2),
                   sample.end());
  return sample[size / 2];
}

}  // namespace plumbline::bucket

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumbline/structure.hpp"

namespace plumbline {

/// What one look at all that the root refers to tells.
struct Checked {
  std::size_t dimension = 0;  ///< of all models and maps; 0 where there are none
  /// Per Struct the models in it and below, each as often as it is referred to; the largest number
  /// stands for that many or more.
  std::vector<std::uint64_t> instances;
};

/// Throws: as `dimension`.
Checked check(const Structure& structure);

}  // namespace plumbline

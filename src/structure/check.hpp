#pragma once

#include <cstddef>
#include <vector>

#include "plumbline/structure.hpp"

namespace plumbline {

/// What one look at all that the root refers to tells.
struct Checked {
  std::size_t dimension = 0;       ///< of all models and maps; 0 where there are none
  std::vector<bool> holds_models;  ///< per Struct: itself or below; false where not referred to
};

/// Throws: as `dimension`.
Checked check(const Structure& structure);

}  // namespace plumbline

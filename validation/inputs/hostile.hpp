#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/geometry.hpp"

/// Inputs on which the time or memory of an arrangement may fall off a cliff: everything in one
/// place, many scales at once, or a quadratic number of pairs behind a small result.
namespace plumbline::inputs {

struct Hostile {
  struct Cells {
    std::uint64_t vertices, edges, faces;
  };

  std::string name;  ///< says what it is
  SegmentSet (*make)(std::uint64_t size);
  std::uint64_t size;        ///< that the benchmark takes
  std::uint64_t small_size;  ///< of the same shape, done in milliseconds
  /// The cells of its arrangement, from its geometry; none where that takes an arrangement to know.
  std::optional<Cells> (*cells)(std::uint64_t size);
};

const std::vector<Hostile>& hostile();

}  // namespace plumbline::inputs

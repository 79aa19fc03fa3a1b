#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "arrange/bucket/job.hpp"
#include "plumbline/geometry.hpp"

namespace plumbline::bucket {

/// The input as integers on the common grid of the drawing's decimals, relative to the middle of
/// the drawing.
struct GridInput {
  std::vector<std::array<std::int64_t, 4>> lines;  ///< ax, ay, bx, by, a first
  mpz_class scale = 1;                             ///< grid units in a unit of the drawing
  mpz_class x, y;                                  ///< the middle, on the grid
  std::int64_t largest = 0;                        ///< absolute value among `lines`

  /// The input's segments, then its points (as lines without length); nothing where a coordinate
  /// does not fit kBits bits.
  static std::optional<GridInput> from(const SegmentSet& input, Job& job);
  static constexpr int kBits = 60;
};

}  // namespace plumbline::bucket

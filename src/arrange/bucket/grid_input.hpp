#pragma once

#include <array>
#include <optional>
#include <vector>

#include "arrange/bucket/exact_lines.hpp"
#include "arrange/bucket/job.hpp"
#include "plumbline/geometry.hpp"

namespace plumbline::bucket {

/// The input as integers on the common grid of all its coordinates, relative to the middle of the
/// drawing.
struct GridInput {
  std::vector<std::array<Int128, 4>> lines;  ///< ax, ay, bx, by, a first
  Frame frame;
  Int128 largest = 0;  ///< absolute value among `lines`

  /// The input's segments, then its points (as lines without length); nothing where a coordinate
  /// does not fit kBits bits.
  static std::optional<GridInput> from(const SegmentSet& input, Job& job);
  static constexpr int kBits = Arithmetic<Int128>::kBits;
};

/// The isolated points as numbers.
std::vector<NumberPoint> numbers_of(const std::vector<Point>& points);

/// Calls visit(k, number) for coordinate k of segment i; those of points come after, twice.
template <class Visit>
void for_numbers(const SegmentList& segments, const std::vector<NumberPoint>& points, std::size_t i,
                 Visit visit) {
  if (i < segments.size()) {
    const auto numbers = segments.numbers(i);
    for (std::size_t k = 0; k < numbers.size(); ++k) visit(k, numbers[k]);
  } else {
    const NumberPoint& p = points[i - segments.size()];
    visit(std::size_t{0}, p.x);
    visit(std::size_t{1}, p.y);
    visit(std::size_t{2}, p.x);
    visit(std::size_t{3}, p.y);
  }
}

}  // namespace plumbline::bucket

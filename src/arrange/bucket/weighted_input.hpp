#pragma once

#include <variant>
#include <vector>

#include "arrange/bucket/exact_lines.hpp"
#include "arrange/bucket/job.hpp"
#include "plumbline/geometry.hpp"

namespace plumbline::bucket {

/// The input as fractions, with a denominator for each line.
struct WeightedInput {
  std::variant<ExactLines<Words>, ExactLines<mpz_class>> lines;  ///< the first where all fit
  /// The same as doubles: relative to a point in the middle of most lines, divided by a power of
  /// two that is greater than any coordinate.
  std::vector<Approx> approx;

  /// The input's segments, then its points (as lines without length).
  static WeightedInput from(const SegmentSet& input, Job& job);
};

/// The same lines.
ExactLines<mpz_class> of_any_size(const ExactLines<Words>& lines);

}  // namespace plumbline::bucket

#pragma once

#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::checking {

/// Pieces in doubles, each with the input segments that it is part of.
struct LineWork {
  std::vector<SegmentD> segments;  ///< those without length count for nothing
  Lists<SegmentId> sources;        ///< per segment
  std::vector<PointD> points;      ///< isolated points
};

/// Every coordinate of the input rounded to the nearest double.
LineWork rounded(const SegmentSet& input);

/// The arrangement of the pieces, their doubles taken as exact. **Exact**. Its sources are those of
/// the pieces. Cost and errors: as `arrange`.
ExactComplex arrange(const LineWork& work, std::size_t threads);

}  // namespace plumbline::checking

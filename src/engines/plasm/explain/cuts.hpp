#pragma once

#include <optional>
#include <span>
#include <vector>

#include "plumbline/engines/plasm.hpp"

namespace plumbline::plasm {

/// A pair of edges that does not cut as their lines do.
struct OddCut {
  enum class Kind {
    Parallel,   ///< they meet, at an angle so small that they count as parallel
    Collinear,  ///< an end of one cuts the other, beside which it is
    Reach       ///< they cut each other beyond their ends
  };
  Kind kind = Kind::Parallel;
  PointD where;
  double distance = 0;  ///< from the other edge, or by which they part; of Parallel 0
  std::vector<SegmentId> segments;
};

class OddCuts {
 public:
  explicit OddCuts(const Trace& trace);
  /// The nearest to p that has two of the segments, else one; none where none has.
  const OddCut* nearest_to(const PointD& p, std::span<const SegmentId> segments) const;

 private:
  std::vector<OddCut> cuts_;
};

}  // namespace plumbline::plasm

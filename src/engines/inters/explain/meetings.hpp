#pragma once

#include <span>
#include <vector>

#include "plumbline/engines/inters.hpp"

namespace plumbline::inters {

/// Two input segments that meet, or nearly so, and were not cut in one common point.
struct MissedMeeting {
  enum class Kind {
    Parallel,   ///< an end of one lies within the other, along it
    Overshoot,  ///< they meet in doubles, and a computed parameter is below 0 or above 1
    NearMiss,   ///< in doubles an end stops beside the other
    Apart,      ///< both are cut, in points that differ
  };
  Kind kind;
  SegmentId first, second;
  PointD where;
  double distance = 0;  ///< NearMiss: end to segment; Apart: of the two cuts. **Rounded**
};

/// Where the published intersection of a run went wrong.
class Meetings {
 public:
  /// Cost: O(members of buckets).
  explicit Meetings(const Trace& trace);

  /// Of those with one of the segments the one nearest to p; none where there is none.
  const MissedMeeting* nearest_to(const PointD& p, std::span<const SegmentId> segments) const;
  /// The same of NearMiss alone.
  const MissedMeeting* near_miss(const PointD& p, std::span<const SegmentId> segments) const;

 private:
  std::vector<MissedMeeting> meetings_;
  std::vector<std::pair<SegmentId, std::size_t>> by_segment_;
};

}  // namespace plumbline::inters

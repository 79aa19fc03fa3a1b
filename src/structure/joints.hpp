#pragma once

#include <span>
#include <vector>

#include "plumbline/structure.hpp"

namespace plumbline {

/// Segments in their places, and which of them are the chords of curves.
struct PlacedCurves {
  const SegmentSet& set;
  std::vector<Curve> curves;     ///< `first` counts the segments of the set
  std::vector<double> rounding;  ///< per segment: `text_rounding` of its ends, under the map
};

/// A vertex that a curve gets: in place of an end of a chord, or within it.
struct Joint {
  enum class At { Start, Inside, End };

  std::size_t chord;  ///< among the segments
  At at;
  Point place;

  friend bool operator==(const Joint&, const Joint&) = default;
};

/// What makes curves meet what meets them in the drawing.
struct Joints {
  std::vector<Joint> joints;  ///< by chord, along it
  std::vector<Replacement> ledger;
  std::vector<Remark> remarks;
};

/// Curves are not known better than their bounds say: an end takes the place of an authored end
/// within its bound, else that of another curve's end, else the nearest place on a line; a curve
/// gets a vertex where an end lies on it within its bound. Bounds are `Curve::end_bounds` or
/// `Curve::bound` plus the rounding of the text of what it meets, at most kMostJoined of the
/// extent. **Exact**: nothing moves further than its bound. Of several ends the nearest; where
/// different ones are equally near the curve stays as it is, and is listed. Independent of the
/// order of segments. Cost: O(n log n).
Joints find_joints(const PlacedCurves& placed);
inline constexpr double kMostJoined = 1e-9;

/// The segments with these vertices.
SegmentSet with_joints(SegmentSet set, const Joints& joints);

}  // namespace plumbline

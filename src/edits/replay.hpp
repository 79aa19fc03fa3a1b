#pragma once

#include <memory>
#include <vector>

#include "edits/lines.hpp"

namespace plumbline::edits {

/// A line that an edit names, and when it is there. State t of the drawing is that before edit t;
/// the last state is the output.
struct Life {
  Line line;
  std::size_t first, last;  ///< states, both included
};

/// A drawing through all its states.
struct Replay {
  std::vector<Life> lives;       ///< of lines that edits name
  std::vector<bool> is_touched;  ///< per input segment: an edit names it. The others stay.
  std::vector<Breach> breaches;  ///< lines that are not there when they are to go, or in the end
};

/// Takes each edit's lines away and puts the others there; holds what comes out against the output.
/// Requires: the repair is well-formed.
Replay replay(const SegmentSet& input, const Repair& repair);

/// Which lines are where and when. Keeps references to what it is made of.
class Drawing {
 public:
  Drawing(const SegmentSet& input, const Replay& replay);
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;
  ~Drawing();

  /// The lines that are there in any of the states first..last, and that have the point; all that
  /// meet the segment, and some near it; all no further from the point, and some that are.
  std::vector<Line> at(const Point& p, std::size_t first, std::size_t last) const;
  std::vector<Line> around(const Segment& s, std::size_t first, std::size_t last) const;
  std::vector<Line> near(const Point& p, const Rational& distance, std::size_t state) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace plumbline::edits

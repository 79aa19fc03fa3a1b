#pragma once

#include <map>
#include <vector>

#include "edits/lines.hpp"

namespace plumbline::edits {

/// How far the lines of each segment may have moved, and what was added to them.
class Moves {
 public:
  explicit Moves(const Repair& repair);

  bool is_any() const { return !kinds_.empty(); }
  bool is_moved(std::span<const SegmentId> segments) const;
  bool is_snapped(std::span<const SegmentId> segments) const;
  /// All edits together.
  Rational bound(std::span<const SegmentId> segments) const;
  /// Pieces that Grow, Bridge or Joint added to lines of one of the segments.
  std::vector<Segment> added_to(std::span<const SegmentId> segments) const;

 private:
  const Tolerances tolerances_;
  std::map<SegmentId, std::vector<EditKind>> kinds_;  ///< of movements
  std::multimap<SegmentId, Segment> added_;
};

}  // namespace plumbline::edits

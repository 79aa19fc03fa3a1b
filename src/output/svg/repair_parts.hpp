#pragma once

#include <string>
#include <vector>

#include "plumbline/edits.hpp"

namespace plumbline {

/// What became of a part of a line.
enum class LineFate {
  Kept,
  Added,
  Removed,
  MovedFrom,  ///< where a line was that lies elsewhere
  MovedTo,
  Virtual,  ///< added as well
};
inline constexpr std::size_t kLineFates = 6;

struct LinePart {
  LineFate fate = LineFate::Kept;
  Segment segment;

  friend bool operator==(const LinePart&, const LinePart&) = default;
};

/// The drawings before and after in one: Kept, Removed and MovedFrom are the input, all but Removed
/// and MovedFrom the output. **Exact**. Order: that of the output, then of the input.
std::vector<LinePart> line_parts(const SegmentSet& input, const Repair& repair);

/// Per face which part of its border, outside and around its holes, is virtual, 0 to 1,
/// **rounded**. `after` is the arrangement of the output.
std::vector<double> virtual_shares(const Repair& repair, const ExactComplex& after);

/// A face that a picture fills: what became of it, or no more than that its border is virtual.
struct ShownFace {
  std::string what;  ///< "closed", ..., as of FaceFate; "virtual"
  bool is_after;     ///< whether it is a face of the output, else of the input
  FaceId face;
  std::string title;  ///< "split 72 -> 36, 4.2 % of its border virtual"
  std::vector<std::size_t> edits;
  Point where;
  double area;
  bool is_other = false;  ///< which of two colours tells it from its neighbours
};

/// Closed and split faces as they are after, joined and opened ones as they were, by outcome; then
/// faces that have nothing but a virtual border, by face. Changed ones are not among them.
std::vector<ShownFace> shown_faces(const Repair& repair, const ExactComplex& after);

}  // namespace plumbline

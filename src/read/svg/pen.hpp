#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plumbline/geometry.hpp"
#include "read/attribute.hpp"
#include "read/flatten.hpp"
#include "read/svg/arc.hpp"

namespace plumbline {

/// What a shape's coordinates draw, the pieces that could not be used, and the numbers that were
/// replaced (without source).
struct Pieces {
  SegmentList segments;
  std::vector<Curve> curves;  ///< parts of ellipses, which segments replace
  std::vector<Ring> rings;    ///< subpaths that are closed, without curves
  std::vector<Unusable> refused;
  std::vector<Replacement> replaced;
};

/// Draws the segments and curves of one shape. Curves become chords; they are counted for the
/// ledger by what they are called.
class SvgPen {
 public:
  /// Replaces what is not rational within `bound`.
  SvgPen(Flattener& flattener, double bound) : flattener_(flattener), bound_(bound) {}

  const NumberPoint& position() const { return current_; }
  const NumberPoint& start() const { return start_; }
  void move_to(NumberPoint point);
  void line_to(NumberPoint end);
  /// Goes there within the subpath, without drawing.
  void jump_to(NumberPoint point);
  /// The Bezier curve from here over the control points to the last of them. Throws: Unusable, and
  /// draws nothing.
  void curve_to(std::span<const NumberPoint> controls, const std::string& what);
  /// The arc, which starts here. Throws: as above.
  void arc_to(const SvgArc& arc, const std::string& what);
  /// A part of an ellipse known within `bound`, the pen being at its start. Throws: as above.
  void draw(const EllipticArc& arc, const std::string& what, double bound = 0);
  /// Back to the start of the subpath, unless the pen is there.
  void close();
  void refuse(Unusable problem) { pieces_.refused.push_back(std::move(problem)); }
  Pieces finish() &&;

 private:
  /// The curves of one kind.
  struct Tally {
    std::string what;
    std::size_t curves = 0, chords = 0;
    double bound = 0;
  };
  void draw(const Chords& chords, const std::string& what);

  Flattener& flattener_;
  double bound_;
  Pieces pieces_;
  NumberPoint current_, start_;
  std::size_t subpath_ = 0;  ///< where its segments begin
  bool is_ring_ = true;      ///< whether it is made of lines that hang together
  std::vector<Tally> tallies_;
};

}  // namespace plumbline

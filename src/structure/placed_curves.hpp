#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "geometry/box_tree.hpp"
#include "geometry/point_d.hpp"
#include "structure/joints.hpp"

namespace plumbline {

/// Segments in their places and curves among them, and what every step that joins them asks.
struct CurvesInPlace {
  const SegmentList& segments;
  const std::vector<Curve>& curves;
  const std::vector<double>& rounding;  ///< per segment
  std::vector<bool> is_chord = {};      ///< per segment
  double extent = 0;
  double slack = 0;  ///< `slack_at` the place of the largest coordinate

  explicit CurvesInPlace(const PlacedCurves& placed);

  PointD rough(std::size_t segment, bool is_b) const;
  SegmentD rough(std::size_t segment) const {
    return {rough(segment, false), rough(segment, true)};
  }
  Point end_of(std::size_t segment, bool is_b) const;
  Point first_point(const Curve& c) const { return end_of(c.first, false); }
  Point last_point(const Curve& c) const { return end_of(c.first + c.count - 1, true); }
  bool is_closed(const Curve& c) const { return first_point(c) == last_point(c); }
  /// The chord that ends where this one of the curve starts, that starts where it ends; none at the
  /// ends of an open curve.
  std::optional<std::size_t> chord_before(const Curve& curve, std::size_t chord) const;
  std::optional<std::size_t> chord_after(const Curve& curve, std::size_t chord) const;
  /// A bound on how far curves may be moved, cut to what they may at all.
  double within(double bound) const;
  /// More than the rounding of a few operations on coordinates there in doubles.
  static double slack_at(const PointD& p);
  /// What may lie within this bound of the point.
  BoxD around(const Point& p, double bound) const;
};

/// A point that curves may be joined to, known within `rounding`; of a curve's own end which one.
struct Authored {
  static constexpr std::size_t kNoCurve = static_cast<std::size_t>(-1);

  Point at;
  double rounding;
  std::size_t curve = kNoCurve;
};
/// The ends of lines, and those of curves that are given by them.
std::vector<Authored> authored_points(const CurvesInPlace& in);

/// The chords of the curves that are parts of ellipses, to be found by what meets the curves.
class ChordTree {
 public:
  explicit ChordTree(const CurvesInPlace& in);

  struct Chord {
    std::size_t segment, curve;
  };
  bool empty() const { return chords_.empty(); }
  const std::vector<Chord>& chords() const { return chords_; }
  const BoxD& box(std::size_t chord) const { return boxes_[chord]; }
  /// Which chords: indices into `chords`.
  const BoxTree& tree() const { return *tree_; }

 private:
  std::vector<Chord> chords_;
  std::vector<BoxD> boxes_;
  std::unique_ptr<BoxTree> tree_;
};

/// A vertex on curves, which they get at points that lie on them.
struct PointsOnCurves {
  std::vector<Joint> joints;
  std::size_t count = 0;
  double farthest = 0;  ///< from the curve
};
/// The points that lie on curves within their bounds. Where the chords have a vertex as near, it
/// moves there, too.
PointsOnCurves points_on_curves(const CurvesInPlace& in, const ChordTree& chords,
                                const std::vector<Authored>& points);
/// Where lines and curves cross curves or touch them, within kCrossing of the extent; not where
/// they have a vertex there already (`known`, sorted by chord).
PointsOnCurves crossings_of_curves(const CurvesInPlace& in, const ChordTree& chords,
                                   const std::vector<Joint>& known);
inline constexpr double kCrossing = 1e-12;

}  // namespace plumbline

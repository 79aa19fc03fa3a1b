#pragma once

#include <span>
#include <string>
#include <vector>

#include "plumbline/read.hpp"
#include "plumbline/structure/curve.hpp"
#include "read/circle_points.hpp"

namespace plumbline {

/// A curve as chords: exact points of the curve from its start to its end, two or more.
struct Chords {
  std::vector<NumberPoint> points;
  /// Between curve and chords nothing is further apart than this; 0 for a curve that is a segment.
  double bound = 0;
};

/// A part of an ellipse, given by points (x, y) of the unit circle.
struct EllipticArc {
  Ellipse ellipse;
  Point start{1, 0};
  Point end;
  bool clockwise = false;  ///< from v to u; else from u to v
};

/// The arc of a circle from a to b that turns counter-clockwise by the angle with this cotangent of
/// its half; clockwise by the angle of -cotangent. **Exact**. Requires: a != b.
EllipticArc arc_between(const Point& a, const Point& b, const Rational& cotangent, bool clockwise);
/// The arc of a circle from a to b with bulge = tan(angle / 4), positive for counter-clockwise.
/// **Exact**. Requires: a != b, bulge != 0. Source: DXF reference, LWPOLYLINE.
EllipticArc bulge_arc(const Point& a, const Point& b, const Rational& bulge);
/// The point of the unit circle at an angle, exact or within `bound`, as `rotation` does it.
struct ApproximatePoint {
  Point point;
  Rational bound;  ///< 0 where it is exact
};
ApproximatePoint circle_point(const Rational& degrees, double bound = kAngleBound);

/// Replaces curves by chords between exact points of the curve, within the options' tolerance, and
/// bounds their number. Throws: Unusable for a curve of more than kMaxChords, Error Limit for a
/// document of more than `max_document_chords`.
class Flattener {
 public:
  static constexpr std::size_t kMaxChords = std::size_t{1} << 17U;
  static constexpr std::size_t kMaxDocumentChords = std::size_t{1} << 24U;

  /// Where the options give no tolerance, a curve's is a thousandth of its longer side or, where
  /// that is more, `least_tolerance`, but at most a tenth of its longer side. Throws: Error
  /// BadInput for a negative tolerance.
  explicit Flattener(const ReadOptions& options, Rational least_tolerance = 0,
                     std::size_t max_document_chords = kMaxDocumentChords);

  bool has_curves() const { return has_curves_; }  ///< whether it had any to replace

  /// A Bezier curve of any degree >= 1 with weights (none: all 1), by de Casteljau at the
  /// parameters i / 2^k. **Exact**. The same points from either end. Degenerate: a loop has at
  /// least four chords. Requires: two points or more; as many weights as points, all positive.
  Chords bezier(std::span<const Point> points, std::span<const Rational> weights = {});
  /// The whole ellipse from `centre + u` on, closed; its quarters are images of each other.
  /// **Exact**. Degenerate: axes of no length give points of a segment.
  Chords ellipse(const Ellipse& ellipse);
  /// **Exact**. Between start and end, the points are images of rational points of the circle over
  /// a small common denominator. The same points from either end. Degenerate: start == end is the
  /// whole ellipse, turned to start there.
  Chords arc(const EllipticArc& arc);

 private:
  /// The square of the tolerance for a curve through these points.
  Rational squared_tolerance(std::span<const Point> points) const;
  void spend(std::size_t chords);

  Rational tolerance_, least_tolerance_;
  CirclePoints circle_points_;
  std::size_t chords_left_;
  bool has_curves_ = false;
};

}  // namespace plumbline

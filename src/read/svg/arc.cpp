#include "read/svg/arc.hpp"

#include <algorithm>
#include <utility>

#include "read/square_root.hpp"

namespace plumbline {
namespace {

/// The linear map from the plane of the unit circle to the drawing: scaling by the radii, then a
/// rotation given by the direction of the x axis.
class EllipseFrame {
 public:
  EllipseFrame(Point axis, Rational rx, Rational ry)
      : axis_(std::move(axis)), rx_(std::move(rx)), ry_(std::move(ry)) {}

  Point out(const Point& p) const {
    const Rational x = rx_ * p.x;
    const Rational y = ry_ * p.y;
    return {axis_.x * x - axis_.y * y, axis_.y * x + axis_.x * y};
  }
  Point in(const Point& p) const {
    return {(axis_.x * p.x + axis_.y * p.y) / rx_, (axis_.x * p.y - axis_.y * p.x) / ry_};
  }

 private:
  Point axis_;
  Rational rx_, ry_;
};

/// The cotangent of half the angle of a circular arc of radius 1 over a chord; 0 where the chord is
/// longer than the diameter.
ApproximateRoot half_cotangent(const Rational& squared_chord, const Rational& bound) {
  // sin(angle / 2) = chord / 2.
  const Rational squared = 4 / squared_chord - 1;
  if (sgn(squared) <= 0) return {0, 0};
  return square_root(squared, bound);
}

}  // namespace

PlacedArc place_arc(const SvgArc& arc, double bound) {
  const Rational rx = abs(arc.rx);
  const Rational ry = abs(arc.ry);
  PlacedArc placed;
  // The axes of a circle may have any direction.
  ApproximatePoint axis{{1, 0}, 0};
  if (rx != ry) axis = circle_point(arc.rotation, bound);
  const std::string bound_digits = shortest_text(bound);
  const double longer = nearest_double(std::max(rx, ry));
  if (axis.bound != 0) {
    placed.replaced.push_back(
        {{}, "rotation of an arc by " + exact_text(arc.rotation), bound_digits + " rad"});
    placed.bound += bound * longer;
  }
  const EllipseFrame frame(axis.point, rx, ry);
  const Point from = frame.in(arc.from);
  const Point to = frame.in(arc.to);
  ApproximateRoot cotangent = half_cotangent(squared_distance(from, to), rational_from(bound));
  // The radius is chord / 2 * sqrt(1 + cotangent^2): its relative change is no larger.
  if (cotangent.bound != 0) {
    placed.replaced.push_back({{}, "radii of an arc", bound_digits + " of themselves"});
    placed.bound += bound * longer;
  }
  if (arc.large) cotangent.value = -cotangent.value;
  placed.arc = arc_between(from, to, cotangent.value, !arc.sweep);
  Ellipse& ellipse = placed.arc.ellipse;
  ellipse = {frame.out(ellipse.centre), frame.out(ellipse.u), frame.out(ellipse.v)};
  return placed;
}

}  // namespace plumbline

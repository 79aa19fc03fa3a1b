#pragma once

#include "plumbline/structure/curve.hpp"

namespace plumbline {

/// The coordinates in which an ellipse is the unit circle about the origin.
class UnitFrame {
 public:
  /// Requires: axes that span the plane (`is_proper`).
  explicit UnitFrame(const Ellipse& ellipse)
      : ellipse_(ellipse), determinant_(determinant(ellipse)) {}

  static bool is_proper(const Ellipse& e) { return sgn(determinant(e)) != 0; }
  Point in(const Point& p) const {
    const Rational x = p.x - ellipse_.centre.x, y = p.y - ellipse_.centre.y;
    return {(x * ellipse_.v.y - y * ellipse_.v.x) / determinant_,
            (y * ellipse_.u.x - x * ellipse_.u.y) / determinant_};
  }

 private:
  static Rational determinant(const Ellipse& e) { return e.u.x * e.v.y - e.u.y * e.v.x; }

  const Ellipse& ellipse_;
  const Rational determinant_;
};

}  // namespace plumbline

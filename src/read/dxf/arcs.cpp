// ARC, CIRCLE and ELLIPSE.

#include <utility>

#include "plumbline/error.hpp"
#include "read/dxf/curves.hpp"
#include "read/dxf/names.hpp"

namespace plumbline::dxf {
namespace {

constexpr int kCentre = 10;
constexpr int kRadius = 40;

DrawnEntity chain(Chords chords, Plane plane, const char* curve) {
  DrawnEntity drawn;
  if (plane == Plane::Back) mirror_x(chords.points);
  append_chain(drawn.segments, chords.points);
  drawn.replaced.push_back(by_chords(curve, chords.bound));
  return drawn;
}

Ellipse circle_of(const Entity& entity) {
  const Rational radius = entity.number(kRadius).rational();
  if (sgn(radius) <= 0) {
    throw Unusable{"radius is not positive", "group 40: " + in_ascii(entity.text(kRadius))};
  }
  return {entity.exact_point(kCentre), {radius, 0}, {0, radius}};
}

/// The part of an ellipse between two angles, counter-clockwise.
DrawnEntity draw_part(const Ellipse& ellipse, const Rational& from, const Rational& to, Plane plane,
                      const char* curve, Pen& pen) {
  const ApproximatePoint start = circle_point(from, pen.angle_bound);
  const ApproximatePoint end = circle_point(to, pen.angle_bound);
  if (start.point == end.point) throw Unusable{"arc of an angle below the bound", {}};
  DrawnEntity drawn = chain(pen.arc({ellipse, start.point, end.point, false}), plane, curve);
  const Rational bound = std::max(start.bound, end.bound);
  if (bound != 0) {
    drawn.replaced.push_back({std::string("end of an ") + curve, nearest_double(bound), "rad"});
  }
  return drawn;
}

Rational degrees_of(const Rational& radians) {
  // 180 / pi within 1e-39: far below any bound on angles.
  return radians * parse_decimal("57.2957795130823208767981548141051703324054");
}

/// A difference of angles modulo a turn, in [0, 360).
Rational within_turn(const Rational& degrees) {
  constexpr int kTurn = 360;
  mpz_class turns;
  const Rational quotient = degrees / kTurn;
  mpz_fdiv_q(turns.get_mpz_t(), quotient.get_num_mpz_t(), quotient.get_den_mpz_t());
  return degrees - turns * kTurn;
}

}  // namespace

Substitution by_chords(const char* curve, double bound) {
  return {std::string(curve) + " by chords", bound, "units"};
}

DrawnEntity draw_arc(const Entity& entity, Pen& pen) {
  const Ellipse circle = circle_of(entity);
  const Rational from = entity.number(50).rational();
  const Rational to = entity.number(51).rational();
  const Plane plane = plane_of(entity);
  if (from == to) throw Unusable{"arc of no angle", "group 51: " + in_ascii(entity.text(51))};
  if (within_turn(to - from) == 0) return chain(pen.ellipse(circle), plane, "arc");
  return draw_part(circle, from, to, plane, "arc", pen);
}

DrawnEntity draw_circle(const Entity& entity, Pen& pen) {
  return chain(pen.ellipse(circle_of(entity)), plane_of(entity), "circle");
}

DrawnEntity draw_ellipse(const Entity& entity, Pen& pen) {
  const Point centre = entity.exact_point(kCentre);
  const Point u = entity.exact_point(11);
  // The normal says on which side of u lies v; the centre and u are in coordinates of the drawing.
  Rational ratio = entity.number(kRadius).rational();
  if (plane_of(entity) == Plane::Back) ratio = -ratio;
  if (u == Point{0, 0} || sgn(ratio) == 0) throw Unusable{"ellipse with an axis of no length", {}};
  const Ellipse ellipse{centre, u, {-ratio * u.y, ratio * u.x}};
  if (!entity.has(41) && !entity.has(42)) {
    return chain(pen.ellipse(ellipse), Plane::Front, "ellipse");
  }
  const Rational from = degrees_of(entity.number(41).rational());
  const Rational to = degrees_of(entity.number(42).rational());
  if (from == to) throw Unusable{"ellipse of no angle", "group 42: " + in_ascii(entity.text(42))};
  // Six digits of 2 pi are within 1e-5; the least that a writer gives is the turn of 6.28318.
  const Rational slack = degrees_of(Rational(1, 100'000));
  const Rational sweep = within_turn(to - from);
  if (sweep > slack && 360 - sweep > slack) {
    return draw_part(ellipse, from, to, Plane::Front, "ellipse", pen);
  }
  if (abs(to - from) < 1) throw Unusable{"arc of an angle below the bound", {}};
  DrawnEntity whole = chain(pen.ellipse(ellipse), Plane::Front, "ellipse");
  whole.replaced.push_back({"end of a whole ellipse by its start", 1e-5, "rad"});
  return whole;
}

}  // namespace plumbline::dxf

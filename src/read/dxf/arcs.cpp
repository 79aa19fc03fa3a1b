// ARC, CIRCLE and ELLIPSE.

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/text_rounding.hpp"
#include "plumbline/error.hpp"
#include "read/dxf/curves.hpp"
#include "read/dxf/names.hpp"

namespace plumbline::dxf {
namespace {

constexpr int kCentre = 10;
constexpr int kRadius = 40;
constexpr double kRadiansPerDegree = 0.017453292519943295;

/// An ellipse, how far it may be from what the file's long numbers were rounded from, and the
/// angles from theirs.
struct Placed {
  Ellipse ellipse;
  double bound = 0;
  double angle_bound = 0;  ///< in radians
};

double longer_axis(const Ellipse& e) {
  const auto length = [](const Point& p) {
    return std::hypot(nearest_double(p.x), nearest_double(p.y));
  };
  return std::hypot(length(e.u), length(e.v));
}

DrawnEntity chain(Chords chords, const Placed& placed, double end_bound, Plane plane,
                  const char* name) {
  DrawnEntity drawn;
  Curve curve{0, 0, placed.ellipse, chords.bound, {end_bound, end_bound}, placed.bound};
  if (plane == Plane::Back) {
    mirror_x(chords.points);
    mirror_x(*curve.ellipse);
  }
  append_curve(drawn, chords.points, std::move(curve));
  drawn.replaced.push_back(by_chords(name, chords.bound));
  return drawn;
}

DrawnEntity whole(const Placed& placed, Plane plane, const char* name, Pen& pen) {
  return chain(pen.ellipse(placed.ellipse), placed, 0, plane, name);
}

Placed circle_of(const Entity& entity) {
  const Number radius = entity.number(kRadius);
  if (sgn(radius) <= 0) {
    throw Unusable{"radius is not positive", "group 40: " + in_ascii(entity.text(kRadius)),
                   sgn(radius) == 0};
  }
  const Rational r = radius.rational();
  return {{entity.exact_point(kCentre), {r, 0}, {0, r}},
          text_rounding(entity.point(kCentre)) + text_rounding(radius, {}),
          0};
}

/// The part of an ellipse between two angles, counter-clockwise.
DrawnEntity draw_part(const Placed& placed, const Rational& from, const Rational& to, Plane plane,
                      const char* curve, Pen& pen) {
  const ApproximatePoint start = circle_point(from, pen.angle_bound);
  const ApproximatePoint end = circle_point(to, pen.angle_bound);
  if (start.point == end.point) throw Unusable{"arc of an angle below the bound", {}};
  const Rational bound = std::max(start.bound, end.bound);
  const double end_bound =
      placed.bound + (placed.angle_bound + nearest_double(bound)) * longer_axis(placed.ellipse);
  DrawnEntity drawn = chain(pen.arc({placed.ellipse, start.point, end.point, false}), placed,
                            end_bound, plane, curve);
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

/// Without its angles. The normal says on which side of u lies v; the centre and u are in
/// coordinates of the drawing.
Placed ellipse_of(const Entity& entity, Plane plane) {
  const Point u = entity.exact_point(11);
  Rational ratio = entity.number(kRadius).rational();
  if (plane == Plane::Back) ratio = -ratio;
  if (u == Point{0, 0} || sgn(ratio) == 0) throw Unusable{"ellipse with an axis of no length", {}};
  const double length = std::hypot(nearest_double(u.x), nearest_double(u.y));
  return {{entity.exact_point(kCentre), u, {-ratio * u.y, ratio * u.x}},
          text_rounding(entity.point(kCentre)) + text_rounding(entity.point(11)) +
              half_unit(entity.number(kRadius)) * length,
          0};
}

DrawnEntity draw_between(const Placed& ellipse, const Rational& from, const Rational& to,
                         Pen& pen) {
  // Six digits of 2 pi are within 1e-5; the least that a writer gives is the turn of 6.28318.
  const Rational slack = degrees_of(Rational(1, 100'000));
  const Rational sweep = within_turn(to - from);
  if (sweep > slack && 360 - sweep > slack) {
    return draw_part(ellipse, from, to, Plane::Front, "ellipse", pen);
  }
  if (abs(to - from) < 1) throw Unusable{"arc of an angle below the bound", {}};
  DrawnEntity drawn = whole(ellipse, Plane::Front, "ellipse", pen);
  if (sweep != 0) drawn.replaced.push_back({"end of a whole ellipse by its start", 1e-5, "rad"});
  return drawn;
}

}  // namespace

Substitution by_chords(const char* curve, double bound) {
  return {std::string(curve) + " by chords", bound, "units"};
}

DrawnEntity draw_arc(const Entity& entity, Pen& pen) {
  Placed circle = circle_of(entity);
  const Rational from = entity.number(50).rational();
  const Rational to = entity.number(51).rational();
  circle.angle_bound = kRadiansPerDegree * std::max(text_rounding(entity.number(50), {}),
                                                    text_rounding(entity.number(51), {}));
  const Plane plane = plane_of(entity);
  if (from == to) throw Unusable{"arc of no angle", "group 51: " + in_ascii(entity.text(51))};
  if (within_turn(to - from) == 0) return whole(circle, plane, "arc", pen);
  return draw_part(circle, from, to, plane, "arc", pen);
}

DrawnEntity draw_circle(const Entity& entity, Pen& pen) {
  return whole(circle_of(entity), plane_of(entity), "circle", pen);
}

DrawnEntity draw_ellipse(const Entity& entity, Pen& pen) {
  constexpr int kFrom = 41, kTo = 42;
  Placed ellipse = ellipse_of(entity, plane_of(entity));
  if (!entity.has(kFrom) && !entity.has(kTo)) return whole(ellipse, Plane::Front, "ellipse", pen);
  const Number from = entity.number(kFrom), to = entity.number(kTo);
  ellipse.angle_bound = std::max(text_rounding(from, {}), text_rounding(to, {}));
  if (from == to) throw Unusable{"ellipse of no angle", "group 42: " + in_ascii(entity.text(kTo))};
  return draw_between(ellipse, degrees_of(from.rational()), degrees_of(to.rational()), pen);
}

DrawnEntity draw_ellipse_by_degrees(const Entity& entity, Pen& pen) {
  Placed ellipse = ellipse_of(entity, Plane::Front);
  const Number from = entity.number(50), to = entity.number(51);
  ellipse.angle_bound =
      kRadiansPerDegree * std::max(text_rounding(from, {}), text_rounding(to, {}));
  if (from == to) throw Unusable{"ellipse of no angle", "group 51: " + in_ascii(entity.text(51))};
  return draw_between(ellipse, from.rational(), to.rational(), pen);
}

}  // namespace plumbline::dxf

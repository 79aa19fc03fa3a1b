// Arcs of circles and ellipses: exact images of rational points of the unit circle.

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/point_d.hpp"
#include "plumbline/error.hpp"
#include "read/attribute.hpp"
#include "read/flatten.hpp"

namespace plumbline {
namespace {

/// Outweighs the rounding of a few operations in doubles.
constexpr double kSafe = 1 - 1e-12;

Point image(const Ellipse& e, const Rational& x, const Rational& y) {
  return {e.centre.x + x * e.u.x + y * e.v.x, e.centre.y + x * e.u.y + y * e.v.y};
}

Point image(const Ellipse& e, const Point& p) { return image(e, p.x, p.y); }

Rational dot(const Point& p, const Point& q) { return p.x * q.x + p.y * q.y; }

/// An upper bound of the ellipse's longer half axis, as a multiple of the longer of u and v.
/// Rounded up.
double stretch(const Ellipse& e, const Rational& longer_squared) {
  const double uu = nearest_double(dot(e.u, e.u) / longer_squared);
  const double vv = nearest_double(dot(e.v, e.v) / longer_squared);
  const double uv = nearest_double(dot(e.u, e.v) / longer_squared);
  return std::sqrt((uu + vv + std::hypot(uu - vv, 2 * uv)) / 2) / kSafe;
}

/// Where on the unit circle a point is: in which quarter, and how high when that is turned to be
/// the first one.
struct Turn {
  std::size_t quarter = 0;
  Rational height;

  friend bool operator<(const Turn& s, const Turn& t) {
    return s.quarter != t.quarter ? s.quarter < t.quarter : s.height < t.height;
  }
};

Turn turn_of(const Point& p) {
  if (sgn(p.x) > 0 && sgn(p.y) >= 0) return {0, p.y};
  if (sgn(p.x) <= 0 && sgn(p.y) > 0) return {1, -p.x};
  if (sgn(p.x) < 0 && sgn(p.y) <= 0) return {2, -p.y};
  return {3, p.x};
}

/// The points of the whole circle, numbered counter-clockwise from (1, 0), round and round.
class WholeCircle {
 public:
  explicit WholeCircle(CircleQuarter quarter) : quarter_(std::move(quarter)) {}

  std::size_t size() const { return 4 * quarter_.points.size(); }
  Point operator[](std::size_t i) const {
    const std::size_t n = quarter_.points.size();
    const auto [x, y] = quarter_.points[i % n];
    const auto over = [this](std::int64_t numerator) {
      Rational r(numerator, quarter_.denominator);
      r.canonicalize();
      return r;
    };
    switch (i / n % 4) {
      case 0:
        return {over(x), over(y)};
      case 1:
        return {over(-y), over(x)};
      case 2:
        return {over(-x), over(-y)};
      default:
        return {over(y), over(-x)};
    }
  }
  /// The number of the first point behind `turn`, or the first one not before it.
  std::size_t first_behind(const Turn& turn) const { return count(turn, true); }
  std::size_t first_not_before(const Turn& turn) const { return count(turn, false); }

 private:
  std::size_t count(const Turn& turn, bool with_equal) const {
    const Rational y = turn.height * Rational(quarter_.denominator);
    const auto before = [&](const CircleQuarter::Integers& p) {
      return with_equal ? p.y <= y : p.y < y;
    };
    const auto& points = quarter_.points;
    const auto end = std::partition_point(points.begin(), points.end(), before);
    return turn.quarter * points.size() + static_cast<std::size_t>(end - points.begin());
  }

  CircleQuarter quarter_;
};

bool no_farther(const Point& p, const Point& q, double distance) {
  constexpr double kRounding = 1e-15;  // of coordinates up to 1
  return plumbline::distance(nearest(p), nearest(q)) + kRounding <= distance;
}

/// The start, then what lies behind it up to the end on the circle, the end. A point next to a
/// start or an end that is none of the circle's is left out where the chord beyond it is not too
/// long.
std::vector<Point> points_between(const WholeCircle& circle, const Point& start, const Point& end,
                                  double longest) {
  const Turn from = turn_of(start);
  const Turn to = turn_of(end);
  std::size_t first = circle.first_behind(from);
  std::size_t last = circle.first_not_before(to) + (from < to ? 0 : circle.size());
  const bool starts_between = circle.first_behind(from) == circle.first_not_before(from);
  const bool ends_between = circle.first_behind(to) == circle.first_not_before(to);
  if (starts_between && first < last &&
      no_farther(start, first + 1 < last ? circle[first + 1] : end, longest)) {
    ++first;
  }
  if (ends_between && first < last &&
      no_farther(end, first + 1 < last ? circle[last - 2] : start, longest)) {
    --last;
  }
  std::vector<Point> points{start};
  for (std::size_t i = first; i < last; ++i) points.push_back(circle[i]);
  points.push_back(end);
  return points;
}

}  // namespace

EllipticArc arc_between(const Point& a, const Point& b, const Rational& cotangent, bool clockwise) {
  const Rational h = (clockwise ? Rational(-cotangent) : cotangent) / 2;
  const Point d{b.x - a.x, b.y - a.y};
  const Point centre{(a.x + b.x) / 2 - h * d.y, (a.y + b.y) / 2 + h * d.x};
  const Point u{a.x - centre.x, a.y - centre.y};
  const Point v{-u.y, u.x};
  const Point w{b.x - centre.x, b.y - centre.y};
  const Rational squared_radius = dot(u, u);
  EllipticArc arc;
  arc.ellipse = {centre, u, v};
  arc.end = {dot(w, u) / squared_radius, dot(w, v) / squared_radius};
  arc.clockwise = clockwise;
  return arc;
}

EllipticArc bulge_arc(const Point& a, const Point& b, const Rational& bulge) {
  return arc_between(a, b, (1 - bulge * bulge) / (2 * abs(bulge)), sgn(bulge) < 0);
}

ApproximatePoint circle_point(const Rational& degrees, double bound) {
  const ApproximateAffine turned = rotation(degrees, bound);
  return {apply(turned.map, Point{1, 0}), turned.bound};
}

Chords Flattener::ellipse(const Ellipse& ellipse) {
  EllipticArc whole;
  whole.ellipse = ellipse;
  whole.end = whole.start;
  return arc(whole);
}

Chords Flattener::arc(const EllipticArc& arc) {
  const auto mirrored = [&arc](const Point& p) { return arc.clockwise ? Point{p.x, -p.y} : p; };
  const Point start = mirrored(arc.start);
  const Point end = mirrored(arc.end);
  Chords chords;
  const Rational longer =
      std::max(dot(arc.ellipse.u, arc.ellipse.u), dot(arc.ellipse.v, arc.ellipse.v));
  if (longer == 0) {
    const Point& c = arc.ellipse.centre;
    chords.points = {{c.x, c.y}, {c.x, c.y}};
    return chords;
  }
  // The box of the curve, or a little less: of its ends and the quarters between them.
  std::vector<Point> box = points_between(WholeCircle({1, {{1, 0}}}), start, end, 0);
  for (Point& p : box) p = image(arc.ellipse, mirrored(p));
  // A chord's middle is the farthest from the circle: by s = 1 - cos(angle / 2), for a chord of
  // length 2 sin(angle / 2). No chord spans more than a quarter.
  const double quarter_error = 1 - std::sqrt(0.5);
  const double stretched = stretch(arc.ellipse, longer);
  const double wanted = nearest_sqrt(squared_tolerance(box) / longer) / stretched * kSafe;
  const double error = std::min(wanted, quarter_error);
  const double longest = 2 * std::sqrt(error * (2 - error)) * kSafe;
  if (longest < CirclePoints::kShortestChord) {
    throw Unusable{"curve of more than " + std::to_string(kMaxChords) + " chords", {}};
  }
  const WholeCircle circle(circle_points_.quarter(longest));
  const std::vector<Point> points = points_between(circle, start, end, longest);
  spend(points.size() - 1);
  chords.points.reserve(points.size());
  for (const Point& p : points) {
    Point on_curve = image(arc.ellipse, mirrored(p));
    chords.points.push_back({std::move(on_curve.x), std::move(on_curve.y)});
  }
  chords.bound = error * stretched * nearest_sqrt(longer);
  return chords;
}

}  // namespace plumbline

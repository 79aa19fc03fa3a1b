// Where lines and curves cross curves: found in doubles, on a decimal grid of what crosses.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "structure/placed_curves.hpp"

namespace plumbline {
namespace {

/// So near an end of its chord, as a part of it, that a crossing is taken for that vertex.
constexpr double kAtVertex = 1e-9;
/// Curves that meet at a smaller angle run along each other: doubles do not tell where they cross.
constexpr double kLeastAngle = 1e-5;

double cross(const PointD& p, const PointD& q) { return p.x * q.y - p.y * q.x; }
double dot(const PointD& p, const PointD& q) { return p.x * q.x + p.y * q.y; }

/// An ellipse in doubles: positions by angles, and the inverse of its map.
class RoughEllipse {
 public:
  explicit RoughEllipse(const Ellipse& e)
      : centre_(nearest(e.centre)), u_(nearest(e.u)), v_(nearest(e.v)) {
    determinant_ = u_.x * v_.y - u_.y * v_.x;
    reach_ = std::hypot(u_.x, u_.y, std::hypot(v_.x, v_.y));
  }

  PointD at(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {centre_.x + c * u_.x + s * v_.x, centre_.y + c * u_.y + s * v_.y};
  }
  PointD direction(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v_.x - s * u_.x, c * v_.y - s * u_.y};
  }
  /// In the coordinates in which it is the unit circle.
  PointD in(const PointD& p) const {
    const double x = p.x - centre_.x, y = p.y - centre_.y;
    return {(x * v_.y - y * v_.x) / determinant_, (y * u_.x - x * u_.y) / determinant_};
  }
  double reach() const { return reach_; }
  const PointD& centre() const { return centre_; }
  /// Of a circle.
  std::optional<double> radius() const {
    const double r = std::hypot(u_.x, u_.y);
    const double skew = std::abs(dot(u_, v_)), excess = std::abs(std::hypot(v_.x, v_.y) - r);
    if (skew > kRound * r * r || excess > kRound * r) return std::nullopt;
    return r;
  }

 private:
  static constexpr double kRound = 0x1p-48;

  PointD centre_, u_, v_;
  double determinant_, reach_;
};

/// Where in a chord's part of the curve something is.
enum class Part { Outside, Inside, AtStart, AtEnd };

/// A multiple of 10^-digits next to a double.
Rational decimal(double value, int digits) {
  mpz_class scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, static_cast<unsigned long>(digits));
  const Rational scaled = rational_from(value) * scale + Rational(1, 2);
  mpz_class floor;
  mpz_fdiv_q(floor.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  Rational result(floor, scale);
  result.canonicalize();
  return result;
}

class Crossings {
 public:
  Crossings(const CurvesInPlace& in, const ChordTree& tree, const std::vector<Joint>& known)
      : in_(in), tree_(tree), known_(known), digits_(digits_of(kCrossing * in.extent)) {
    for (const Curve& curve : in.curves) {
      ellipses_.push_back(curve.ellipse ? std::optional<RoughEllipse>(*curve.ellipse)
                                        : std::nullopt);
    }
  }

  PointsOnCurves run() && {
    const std::vector<std::size_t> order = group_chords();
    std::vector<BoxD> boxes;
    for (const std::size_t i : order) boxes.push_back(tree_.box(i));
    const BoxTree tree(boxes);
    for (const std::size_t s : lines_in_order(tree)) {
      for (const std::size_t k : tree.meeting(in_.rough(s))) cross_by_line(s, order[k]);
    }
    for (std::size_t k = 0; k < order.size(); ++k) {
      for (const std::size_t l : tree.meeting(boxes[k])) {
        if (k < l && ellipse_at(order[k]) != ellipse_at(order[l])) {
          cross_by_curve(order[k], order[l]);
        }
      }
    }
    return std::move(result_);
  }

 private:
  /// The digits behind the point that tell places so far apart.
  static int digits_of(double apart) {
    return apart > 0 ? std::max(0, static_cast<int>(std::ceil(-std::log10(apart)))) : 0;
  }
  std::size_t curve_of(std::size_t i) const { return tree_.chords()[i].curve; }
  /// Whether the grid of crossings is fine beside the curve; else, in a drawing with something far
  /// away, it crosses by its chords.
  bool is_large(std::size_t i) const {
    constexpr double kFine = 1e-6;
    return kCrossing * in_.extent + in_.slack <= kFine * ellipse_of(i).reach();
  }
  const RoughEllipse& ellipse_of(std::size_t i) const { return *ellipses_[curve_of(i)]; }
  SegmentD chord_of(std::size_t i) const { return in_.rough(tree_.chords()[i].segment); }

  // Earlier crossings are used again, so their order must not be that of the input.
  std::vector<std::size_t> lines_in_order(const BoxTree& tree) const;
  std::vector<std::size_t> group_chords();
  const Ellipse& ellipse_at(std::size_t i) const { return *in_.curves[curve_of(i)].ellipse; }

  Part part_at(std::size_t i, const PointD& place) const;
  /// The vertex at the start or the end of a chord.
  Point vertex(std::size_t i, Part part) const {
    return in_.end_of(tree_.chords()[i].segment, part == Part::AtEnd);
  }
  bool has_vertex_on(std::size_t i, const Point& a, const Point& b) const;
  void cross_by_line(std::size_t segment, std::size_t i);
  void cross_at(std::size_t segment, std::size_t i, double t);
  void cross_by_curve(std::size_t i, std::size_t j);
  std::vector<PointD> meetings_of_circles(std::size_t i, std::size_t j, double r, double s) const;
  std::vector<PointD> meetings_of_ellipses(std::size_t i, std::size_t j) const;
  std::optional<PointD> meeting(std::size_t i, std::size_t j, double start_i, double start_j) const;
  void add(std::size_t i, Part part, const Point& place);

  const CurvesInPlace& in_;
  const ChordTree& tree_;
  const std::vector<Joint>& known_;
  const int digits_;
  std::vector<std::optional<RoughEllipse>> ellipses_;
  std::vector<std::vector<std::size_t>> copies_;      ///< of the first chord of a group, itself too
  std::map<std::size_t, std::vector<Point>> places_;  ///< found so far, by segment of the chord
  PointsOnCurves result_;
};

/// The lines near curves, by their ends.
std::vector<std::size_t> Crossings::lines_in_order(const BoxTree& tree) const {
  std::vector<std::tuple<Point, Point, std::size_t>> lines;
  for (std::size_t s = 0; s < in_.segments.size(); ++s) {
    if (in_.is_chord[s] || tree.meeting(in_.rough(s)).empty()) continue;
    Point a = in_.end_of(s, false), b = in_.end_of(s, true);
    if (b < a) std::swap(a, b);
    lines.emplace_back(std::move(a), std::move(b), s);
  }
  std::sort(lines.begin(), lines.end());
  std::vector<std::size_t> order;
  for (const auto& line : lines) order.push_back(std::get<2>(line));
  return order;
}

/// One of each group of the same chords, by their ellipses and their ends; the others are its
/// copies.
std::vector<std::size_t> Crossings::group_chords() {
  std::vector<std::size_t> order(tree_.chords().size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto ends = [&](std::size_t i) {
    return std::pair(vertex(i, Part::AtStart), vertex(i, Part::AtEnd));
  };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    const Ellipse &e = ellipse_at(i), &f = ellipse_at(j);
    if (!(e == f)) return std::tie(e.centre, e.u, e.v) < std::tie(f.centre, f.u, f.v);
    return ends(i) < ends(j);
  });
  std::vector<std::size_t> groups;
  copies_.resize(order.size());
  for (const std::size_t i : order) {
    if (groups.empty() || !(ellipse_at(groups.back()) == ellipse_at(i)) ||
        ends(groups.back()) != ends(i)) {
      groups.push_back(i);
    }
    copies_[groups.back()].push_back(i);
  }
  return groups;
}

Part Crossings::part_at(std::size_t i, const PointD& place) const {
  const RoughEllipse& ellipse = ellipse_of(i);
  const auto [a, b] = chord_of(i);
  const Curve& curve = in_.curves[curve_of(i)];
  const double bound = curve.bound + std::max(curve.end_bounds[0], curve.end_bounds[1]);
  const double reach = kAtVertex * distance(a, b) + kCrossing * in_.extent + in_.within(bound);
  if (distance(place, a) <= reach) return Part::AtStart;
  if (distance(place, b) <= reach) return Part::AtEnd;
  const PointD from = ellipse.in(a), to = ellipse.in(b), q = ellipse.in(place);
  const double way = cross(from, to);
  const bool is_inside = way != 0 && cross(from, q) * way > 0 && cross(q, to) * way > 0;
  return is_inside ? Part::Inside : Part::Outside;
}

/// Whether the chord has a vertex on the segment already.
bool Crossings::has_vertex_on(std::size_t i, const Point& a, const Point& b) const {
  const std::size_t segment = tree_.chords()[i].segment;
  const auto is_before = [](const Joint& j, std::size_t s) { return j.chord < s; };
  for (auto j = std::lower_bound(known_.begin(), known_.end(), segment, is_before);
       j != known_.end() && j->chord == segment; ++j) {
    if (on_segment(a, b, j->place)) return true;
  }
  const auto found = places_.find(segment);
  return found != places_.end() && std::any_of(found->second.begin(), found->second.end(),
                                               [&](const Point& p) { return on_segment(a, b, p); });
}

void Crossings::cross_by_line(std::size_t segment, std::size_t i) {
  if (!is_large(i)) return;
  const RoughEllipse& ellipse = ellipse_of(i);
  auto ends = in_.rough(segment);
  if (in_.end_of(segment, true) < in_.end_of(segment, false)) std::swap(ends.a, ends.b);
  const PointD a = ellipse.in(ends.a), b = ellipse.in(ends.b);
  const PointD d{b.x - a.x, b.y - a.y};
  const double squared = dot(d, d), along = dot(a, d);
  if (!(squared > 0)) return;
  const double from_centre = std::abs(cross(a, d)) / std::sqrt(squared);
  const double bound = in_.within(in_.curves[curve_of(i)].bound + in_.rounding[segment]);
  if (std::abs(from_centre - 1) <= (bound + in_.slack) / ellipse.reach()) {
    cross_at(segment, i, -along / squared);  // it touches the curve
    return;
  }
  const double root = along * along - squared * (dot(a, a) - 1);
  if (root <= 0) return;
  for (const double sign : {-1.0, 1.0}) {
    cross_at(segment, i, (-along + sign * std::sqrt(root)) / squared);
  }
}

/// A point of the segment, by its part of it from the lesser end on: the same for either direction.
void Crossings::cross_at(std::size_t segment, std::size_t i, double t) {
  Point a = in_.end_of(segment, false), b = in_.end_of(segment, true);
  if (b < a) std::swap(a, b);
  const SegmentD rough{nearest(a), nearest(b)};
  const double reach = distance(rough.a, rough.b);
  if (t * reach <= in_.slack || (1 - t) * reach <= in_.slack) return;
  const Part part = part_at(i, point_at(rough, t));
  if (part == Part::Outside || has_vertex_on(i, a, b)) return;
  if (part != Part::Inside && on_segment(a, b, vertex(i, part))) return;
  const Rational exact = decimal(t, digits_of(kCrossing * in_.extent / reach));
  if (sgn(exact) <= 0 || cmp(exact, 1) >= 0) return;
  add(i, part, {a.x + exact * (b.x - a.x), a.y + exact * (b.y - a.y)});
}

/// Where two circles meet: one place where they touch within the bound.
std::vector<PointD> Crossings::meetings_of_circles(std::size_t i, std::size_t j, double r,
                                                   double s) const {
  const PointD &c = ellipse_of(i).centre(), &d = ellipse_of(j).centre();
  const PointD between{d.x - c.x, d.y - c.y};
  const double apart = std::hypot(between.x, between.y);
  const auto bound_of = [&](std::size_t k) {
    const Curve& curve = in_.curves[curve_of(k)];
    return std::max({curve.bound, curve.end_bounds[0], curve.end_bounds[1]});
  };
  const double bound = in_.within(bound_of(i) + bound_of(j)) + in_.slack;
  if (apart <= bound) return {};
  const PointD way{between.x / apart, between.y / apart};
  const auto at = [&](double along, double beside) {
    return PointD{c.x + along * way.x - beside * way.y, c.y + along * way.y + beside * way.x};
  };
  if (std::abs(apart - (r + s)) <= bound || std::abs(apart + s - r) <= bound) return {at(r, 0)};
  if (std::abs(apart + r - s) <= bound) return {at(-r, 0)};
  const double along = (apart + (r - s) * (r + s) / apart) / 2;
  const double beside = (r - along) * (r + along);
  // Their angle has the sine apart sqrt(beside) / (r s).
  if (!(beside > 0) || apart * std::sqrt(beside) < kLeastAngle * r * s) return {};
  return {at(along, std::sqrt(beside)), at(along, -std::sqrt(beside))};
}

/// Where two ellipses meet near chord i: from its ends and its middle on by Newton's rule.
std::vector<PointD> Crossings::meetings_of_ellipses(std::size_t i, std::size_t j) const {
  const auto angle = [&](std::size_t k, const PointD& p) {
    const PointD q = ellipse_of(k).in(p);
    return std::atan2(q.y, q.x);
  };
  const SegmentD a = chord_of(i);
  std::vector<PointD> found;
  for (const PointD& p : {a.a, a.b, point_at(a, 0.5)}) {
    const std::optional<PointD> place = meeting(i, j, angle(i, p), angle(j, p));
    if (!place) continue;
    const bool is_new = std::none_of(found.begin(), found.end(), [&](const PointD& other) {
      return distance(other, *place) <= kCrossing * in_.extent;
    });
    if (is_new) found.push_back(*place);
  }
  return found;
}

/// From a pair of angles to where the curves meet, by Newton's rule; not where they touch or are
/// the same: this rule can't tell where.
std::optional<PointD> Crossings::meeting(std::size_t i, std::size_t j, double s, double t) const {
  constexpr int kSteps = 20;
  const RoughEllipse &e = ellipse_of(i), &f = ellipse_of(j);
  for (int step = 0; step < kSteps; ++step) {
    const PointD p = e.at(s), q = f.at(t);
    const PointD gap{q.x - p.x, q.y - p.y};
    const PointD u = e.direction(s), v = f.direction(t);
    const double determinant = cross(u, v);
    const double least = kLeastAngle * std::hypot(u.x, u.y) * std::hypot(v.x, v.y);
    if (!(std::abs(determinant) > least)) return std::nullopt;
    if (std::hypot(gap.x, gap.y) <= in_.slack) return p;
    s += cross(gap, v) / determinant;
    t += cross(gap, u) / determinant;
  }
  return std::nullopt;
}

void Crossings::cross_by_curve(std::size_t i, std::size_t j) {
  if (!is_large(i) || !is_large(j)) return;
  const auto r = ellipse_of(i).radius(), s = ellipse_of(j).radius();
  const std::vector<PointD> found =
      r && s ? meetings_of_circles(i, j, *r, *s) : meetings_of_ellipses(i, j);
  for (const PointD& place : found) {
    const Part on_i = part_at(i, place), on_j = part_at(j, place);
    if (on_i == Part::Outside || on_j == Part::Outside) continue;
    const auto exact_place = [&]() -> Point {
      for (const auto& [k, part] : {std::pair(i, on_i), std::pair(j, on_j)}) {
        if (part == Part::Inside) continue;
        const Point v = vertex(k, part);
        if (distance(nearest(v), place) <= kCrossing * in_.extent) return v;
      }
      return {decimal(place.x, digits_), decimal(place.y, digits_)};
    }();
    add(i, on_i, exact_place);
    add(j, on_j, exact_place);
  }
}

/// A vertex of the curve and of its copies; near one that its chords have already this one moves
/// there, unless the curve ends in it.
void Crossings::add(std::size_t i, Part part, const Point& place) {
  if (part != Part::Inside && vertex(i, part) == place) return;
  const std::size_t before = result_.joints.size();
  for (const std::size_t copy : copies_[i]) {
    const auto& [segment, c] = tree_.chords()[copy];
    if (part == Part::Inside) {
      result_.joints.push_back({segment, Joint::At::Inside, place});
      continue;
    }
    const Curve& curve = in_.curves[c];
    const bool is_start = part == Part::AtStart;
    const auto other =
        is_start ? in_.chord_before(curve, segment) : in_.chord_after(curve, segment);
    if (!other) continue;
    result_.joints.push_back({is_start ? *other : segment, Joint::At::End, place});
    result_.joints.push_back({is_start ? segment : *other, Joint::At::Start, place});
  }
  if (result_.joints.size() == before) return;
  places_[tree_.chords()[i].segment].push_back(place);
  ++result_.count;
  const PointD q = ellipse_of(i).in(nearest(place));
  const double off = std::abs(std::hypot(q.x, q.y) - 1) * ellipse_of(i).reach();
  result_.farthest = std::max(result_.farthest, off + in_.slack);
}

}  // namespace

PointsOnCurves crossings_of_curves(const CurvesInPlace& in, const ChordTree& chords,
                                   const std::vector<Joint>& known) {
  if (chords.empty()) return {};
  return Crossings(in, chords, known).run();
}

}  // namespace plumbline

// Intersection of two segments. What lies within the radius is decided first, by distance; a proper
// crossing is computed only where no end is that near, so that the parameters need no tolerance.

#include <algorithm>
#include <optional>

#include "engines/lar/stages/points.hpp"
#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {
namespace {

double cross(const PointD& u, const PointD& v) { return u.x * v.y - u.y * v.x; }
double dot(const PointD& u, const PointD& v) { return u.x * v.x + u.y * v.y; }
PointD minus(const PointD& p, const PointD& q) { return {p.x - q.x, p.y - q.y}; }

/// The parameter of the point of s nearest to p, if p is within the radius of it.
std::optional<double> foot(const PointD& p, const SegmentD& s, double radius) {
  const PointD direction = minus(s.b, s.a);
  const PointD to_p = minus(p, s.a);
  const double along = dot(to_p, direction);
  const double squared_length = dot(direction, direction);
  if (along <= 0) return near(p, s.a, radius) ? std::optional(0.0) : std::nullopt;
  if (along >= squared_length) return near(p, s.b, radius) ? std::optional(1.0) : std::nullopt;
  const double area = cross(direction, to_p);
  if (area * area > radius * radius * squared_length) return std::nullopt;
  return along / squared_length;
}

/// Whether leading s through p gives two shorter segments. In a triangle with all heights within
/// the radius this cuts the longest side only; cutting each side at its opposite corner would go on
/// for ever. What stays uncut is further than 0.86 radii from s.
bool shortens(const SegmentD& s, const PointD& p) {
  const double length = squared_distance(s.a, s.b);
  return squared_distance(s.a, p) < length && squared_distance(p, s.b) < length;
}

/// Cuts s at those ends of `other` that are near it; whether there are any that are cut or will be
/// merged with an end of s.
bool cut_at_ends(const SegmentD& s, const SegmentD& other, double radius, CutPair& cuts) {
  bool touches = false;
  for (const PointD& end : {other.a, other.b}) {
    const std::optional<double> parameter = foot(end, s, radius);
    if (!parameter) continue;
    const bool merges = near(end, s.a, radius) || near(end, s.b, radius);
    if (!merges && !shortens(s, end)) continue;
    touches = true;
    if (!merges) cuts.push_back({*parameter, end});
  }
  return touches;
}

/// The point of s at the parameter, from the nearer end. Never -0.
PointD point_from_nearer_end(const SegmentD& s, double parameter) {
  const PointD direction = minus(s.b, s.a);
  if (parameter <= 0.5) {
    return {s.a.x + parameter * direction.x + 0.0, s.a.y + parameter * direction.y + 0.0};
  }
  const double rest = 1 - parameter;
  return {s.b.x - rest * direction.x + 0.0, s.b.y - rest * direction.y + 0.0};
}

/// How the ends of a segment lie by the line through another one.
enum class Sides {
  Clear,     ///< further than the radius from the line, both on the same side
  Opposite,  ///< further than the radius from the line, one on each side
  Near,      ///< one of them is within the radius
};

Sides sides(const SegmentD& line, const SegmentD& other, double radius) {
  const PointD direction = minus(line.b, line.a);
  const double first = cross(direction, minus(other.a, line.a));
  const double second = cross(direction, minus(other.b, line.a));
  const double limit = radius * radius * dot(direction, direction);
  if (!(first * first > limit && second * second > limit)) return Sides::Near;
  return (first > 0) == (second > 0) ? Sides::Clear : Sides::Opposite;
}

/// Whether the segments have an end in common, and both other ends are further than the radius from
/// the line through the other segment: then they meet nowhere else.
bool fork(const SegmentD& first, const SegmentD& second, double radius) {
  const bool at_a = first.a == second.a || first.a == second.b;
  if (!at_a && first.b != second.a && first.b != second.b) return false;
  const PointD& common = at_a ? first.a : first.b;
  const PointD u = minus(at_a ? first.b : first.a, common);
  const PointD v = minus(second.a == common ? second.b : second.a, common);
  const double area = cross(u, v);
  return area * area > radius * radius * std::max(dot(u, u), dot(v, v));
}

}  // namespace

Meeting meet(const SegmentD& first, const SegmentD& second, double radius) {
  Meeting meeting;
  if (fork(first, second, radius)) return meeting;
  const Sides of_second = sides(first, second, radius);
  if (of_second == Sides::Clear) return meeting;
  const Sides of_first = sides(second, first, radius);
  if (of_first == Sides::Clear) return meeting;
  if (of_first == Sides::Near || of_second == Sides::Near) {
    const bool first_touched = cut_at_ends(first, second, radius, meeting.on_first);
    const bool second_touched = cut_at_ends(second, first, radius, meeting.on_second);
    if (first_touched || second_touched) return meeting;
  }

  const PointD first_direction = minus(first.b, first.a);
  const PointD second_direction = minus(second.b, second.a);
  const double determinant = cross(first_direction, second_direction);
  if (determinant == 0) return meeting;
  const PointD between = minus(second.a, first.a);
  const double alpha = cross(between, second_direction) / determinant;
  const double beta = cross(between, first_direction) / determinant;
  if (!(alpha > 0 && alpha < 1 && beta > 0 && beta < 1)) return meeting;
  const PointD point = point_from_nearer_end(first, alpha);
  meeting.on_first.push_back({alpha, point});
  meeting.on_second.push_back({beta, point});
  return meeting;
}

}  // namespace plumbline::lar

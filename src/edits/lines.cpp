#include "edits/lines.hpp"

#include <algorithm>
#include <utility>

#include "plumbline/error.hpp"

namespace plumbline::edits {

std::vector<Segment> extents_of(std::span<const Line> lines) {
  std::vector<Segment> result;
  for (const Line& line : lines) result.push_back(extent_of(line));
  return result;
}

bool is_collinear(const Segment& s, const Segment& t) {
  return orientation(s.a, s.b, t.a) == 0 && orientation(s.a, s.b, t.b) == 0;
}

bool covers(const Segment& whole, const Segment& part) {
  return on_segment(whole.a, whole.b, part.a) && on_segment(whole.a, whole.b, part.b);
}

bool meets_inside(const Segment& segment, const Segment& other) {
  const auto is_inside = [&](const Point& p) { return segment.a < p && p < segment.b; };
  const int a = orientation(segment.a, segment.b, other.a);
  const int b = orientation(segment.a, segment.b, other.b);
  if (a == 0 && b == 0) return other.a < segment.b && segment.a < other.b;
  if (a == 0) return is_inside(other.a);
  if (b == 0) return is_inside(other.b);
  return a != b &&
         orientation(other.a, other.b, segment.a) * orientation(other.a, other.b, segment.b) < 0;
}

std::optional<Point> crossing(const Segment& s, const Segment& t) {
  const Rational x = s.b.x - s.a.x, y = s.b.y - s.a.y;
  const Rational turn = x * (t.b.y - t.a.y) - y * (t.b.x - t.a.x);
  if (turn == 0) return {};
  const Rational part =
      ((t.a.x - s.a.x) * (t.b.y - t.a.y) - (t.a.y - s.a.y) * (t.b.x - t.a.x)) / turn;
  if (part < 0 || part > 1) return {};
  Point meeting = {s.a.x + part * x, s.a.y + part * y};
  if (!on_segment(t.a, t.b, meeting)) return {};
  return meeting;
}

std::vector<Segment> without(std::vector<Segment> segments, std::span<const Line> lines) {
  for (const Line& line : lines) {
    std::vector<Segment> left;
    for (Segment& s : segments) {
      if (!is_collinear(s, extent_of(line)) || !(line.a < s.b) || !(s.a < line.b)) {
        left.push_back(std::move(s));
        continue;
      }
      if (s.a < line.a) left.push_back({s.a, line.a});
      if (line.b < s.b) left.push_back({line.b, s.b});
    }
    segments = std::move(left);
  }
  return segments;
}

Rational squared_distance(const Point& p, std::span<const Segment> segments) {
  ensure(!segments.empty(), "a distance is one from something");
  Rational least = squared_distance(p, segments[0].a, segments[0].b);
  for (const Segment& s : segments.subspan(1)) {
    least = std::min(least, squared_distance(p, s.a, s.b));
  }
  return least;
}

Rational farthest_end(std::span<const Segment> from, std::span<const Segment> to) {
  Rational most = 0;
  for (const Segment& s : from) {
    most = std::max({most, squared_distance(s.a, to), squared_distance(s.b, to)});
  }
  return most;
}

std::vector<SegmentId> segments_of(std::span<const Line> lines) {
  std::vector<SegmentId> result;
  for (const Line& line : lines) {
    const auto middle = static_cast<std::ptrdiff_t>(result.size());
    result.insert(result.end(), line.segments.begin(), line.segments.end());
    std::inplace_merge(result.begin(), result.begin() + middle, result.end());
  }
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

bool share_segment(std::span<const SegmentId> a, std::span<const SegmentId> b) {
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i] == b[j]) return true;
    a[i] < b[j] ? ++i : ++j;
  }
  return false;
}

Segment ordered(Segment segment) {
  if (segment.b < segment.a) std::swap(segment.a, segment.b);
  return segment;
}

std::string length_text(const Rational& squared) { return shortest_text(nearest_sqrt(squared)); }

}  // namespace plumbline::edits

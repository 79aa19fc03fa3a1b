#include <algorithm>

#include "plumbline/engines/lar.hpp"

namespace plumbline::lar {
namespace {

struct Window {
  Point low, high;
};

Window window_of(const SegmentSet& input) {
  std::vector<Point> points = input.points;
  for (std::size_t i = 0; i < input.segments.size(); ++i) {
    const Segment& segment = input.segments[i];
    points.push_back(segment.a);
    points.push_back(segment.b);
  }
  if (points.empty()) return {};
  const auto by_y = [](const Point& p, const Point& q) { return p.y < q.y; };
  const auto [left, right] = std::minmax_element(points.begin(), points.end());
  const auto [low, high] = std::minmax_element(points.begin(), points.end(), by_y);
  return {{left->x, low->y}, {right->x, high->y}};
}

}  // namespace

SegmentSet to_unit_square(const SegmentSet& input) {
  const Window window = window_of(input);
  Rational side =
      std::max(Rational(window.high.x - window.low.x), Rational(window.high.y - window.low.y));
  if (side == 0) side = 1;
  const auto mapped = [&](const Point& p) {
    return Point{(p.x - window.low.x) / side, 1 - (p.y - window.low.y) / side};
  };
  SegmentSet result;
  result.files = input.files;
  result.sources = input.sources;
  result.rejected = input.rejected;
  result.remarks = input.remarks;
  result.ledger = input.ledger;
  for (std::size_t i = 0; i < input.segments.size(); ++i) {
    const Segment& segment = input.segments[i];
    result.add({mapped(segment.a), mapped(segment.b)}, input.segment_source[i]);
    if (input.rounding.empty()) continue;
    result.rounding.resize(result.segments.size());
    result.rounding.back() = input.rounding[i] / nearest_double(side);
  }
  if (result.segments.size() == input.segments.size()) result.rings = input.rings;
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    result.add_point(mapped(input.points[i]), input.point_source[i]);
  }
  return result;
}

}  // namespace plumbline::lar

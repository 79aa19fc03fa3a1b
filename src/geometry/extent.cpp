// The extent of a drawing that an element far away does not change.

#include "plumbline/geometry/extent.hpp"

#include <cmath>
#include <utility>

#include "geometry/point_d.hpp"

namespace plumbline {
namespace {

/// The first and the third quartile.
std::pair<double, double> quartiles(std::vector<double> values) {
  const auto at = [&](std::size_t i) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(i);
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  const std::size_t quarter = values.size() / 4;
  const double low = at(quarter);
  return {low, at(values.size() - 1 - quarter)};
}

BoxD middle(std::span<const SegmentD> segments) {
  std::vector<double> xs, ys;
  xs.reserve(segments.size());
  ys.reserve(segments.size());
  for (const SegmentD& s : segments) {
    xs.push_back(s.a.x / 2 + s.b.x / 2);
    ys.push_back(s.a.y / 2 + s.b.y / 2);
  }
  const auto [left, right] = quartiles(std::move(xs));
  const auto [low, high] = quartiles(std::move(ys));
  return {{left, low}, {right, high}};
}

/// How far the box of a segment is from a box, along the axis where that is more.
double gap(const BoxD& box, const SegmentD& s) {
  return std::max({0.0, std::min(s.a.x, s.b.x) - box.high.x, box.low.x - std::max(s.a.x, s.b.x),
                   std::min(s.a.y, s.b.y) - box.high.y, box.low.y - std::max(s.a.y, s.b.y)});
}

BoxD box_of(std::span<const SegmentD> segments) {
  BoxD box{segments.front().a, segments.front().a};
  for (const SegmentD& s : segments) {
    box.include(s.a);
    box.include(s.b);
  }
  return box;
}

struct Away {
  double gap, length;
  std::size_t segment;

  friend bool operator<(const Away& a, const Away& b) {
    if (a.gap != b.gap) return a.gap < b.gap;
    return a.length != b.length ? a.length > b.length : a.segment < b.segment;
  }
};

}  // namespace

Extent extent(std::span<const SegmentD> segments) {
  if (segments.empty()) return {};
  const BoxD all = box_of(segments), core = middle(segments);
  const Extent whole{all.low, all.high, {}, 0};
  if (whole.longer_side() <= kStraySizes * core.longer_side()) return whole;

  std::vector<Away> order;
  order.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    order.push_back({gap(core, segments[i]), box_of(segments.subspan(i, 1)).longer_side(), i});
  }
  std::sort(order.begin(), order.end());
  BoxD box = core;
  std::size_t joined = 0;
  for (; joined < order.size(); ++joined) {
    const auto& [away, length, segment] = order[joined];
    if (joined > 0 && away > std::max(length, kStraySizes * box.longer_side())) break;
    box.include(segments[segment].a);
    box.include(segments[segment].b);
  }
  const std::size_t strays = order.size() - joined;
  if (strays == 0 || strays > order.size() / 4) return whole;
  Extent result{box.low, box.high, {}, order[joined].gap / box.longer_side()};
  for (std::size_t i = joined; i < order.size(); ++i) result.stray.push_back(order[i].segment);
  std::sort(result.stray.begin(), result.stray.end());
  return result;
}

Extent extent(const SegmentSet& input) {
  std::vector<SegmentD> segments;
  segments.reserve(input.segments.size());
  for (std::size_t i = 0; i < input.segments.size(); ++i) {
    const auto n = input.segments.numbers(i);
    segments.push_back({{nearest_double(n[0]), nearest_double(n[1])},
                        {nearest_double(n[2]), nearest_double(n[3])}});
  }
  return extent(segments);
}

}  // namespace plumbline

// From exact segments to a graph of distinct segments in doubles. All later stages may rely on
// coordinates between 2^-100 and 2^100 in size (smaller ones count as 0 beside the largest), so
// that products of four of them are finite.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "engines/lar/stages/points.hpp"
#include "geometry/point_d.hpp"
#include "plumbline/engines/lar_stages.hpp"
#include "plumbline/error.hpp"
#include "plumbline/geometry/extent.hpp"

namespace plumbline::lar {
namespace {

constexpr int kLargestPlainExponent = 100;

struct SourcedSegment {
  SegmentD segment;
  SegmentId id;

  friend bool operator<(const SourcedSegment& s, const SourcedSegment& t) {
    if (s.segment.a != t.segment.a) return s.segment.a < t.segment.a;
    if (s.segment.b != t.segment.b) return s.segment.b < t.segment.b;
    return s.id < t.id;
  }
};

template <class P>
PointD finite(const P& p, const char* what, std::size_t id) {
  const PointD rounded = nearest(p);
  if (!std::isfinite(rounded.x) || !std::isfinite(rounded.y)) {
    throw Error(
        ErrorCode::BadInput,
        std::string("coordinate beyond the largest double in ") + what + " " + std::to_string(id),
        {}, to_text(p));
  }
  return rounded;
}

PointD scaled(const PointD& p, int exponent) {
  if (exponent == 0) return p;
  return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
}

/// The wanted radius, not less than rounding and not more than what merges everything.
void choose_radius(Drawing& drawing, const Options& options) {
  const std::vector<PointD>& vertices = drawing.graph.vertices;
  const double largest = largest_coordinate(vertices);
  double wanted = 0;
  if (options.radius) {
    wanted = std::ldexp(*options.radius, -drawing.exponent);
  } else {
    std::vector<SegmentD> segments;
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& [v, w] : drawing.graph.edges) {
      segments.push_back({vertices[v], vertices[w]});
      if (v != w) shortest = std::min(shortest, distance(vertices[v], vertices[w]));
    }
    wanted = kDefaultRelativeRadius * extent(segments).longer_side();
    const double most = std::max(kMostOfSegment * shortest, kLeastRelativeRadius * largest);
    drawing.radius_from_segment = most < wanted;
    wanted = std::min(wanted, most);
  }
  // One vertex at most: any radius does.
  drawing.radius =
      largest == 0 ? 1 : std::clamp(wanted, kLeastRelativeRadius * largest, 4 * largest);
}

void append_distinct(Graph& graph, std::span<const SourcedSegment> sorted) {
  for (std::size_t i = 0; i < sorted.size();) {
    const SegmentD& segment = sorted[i].segment;
    std::vector<SegmentId> ids;
    for (;
         i < sorted.size() && sorted[i].segment.a == segment.a && sorted[i].segment.b == segment.b;
         ++i) {
      ids.push_back(sorted[i].id);
    }
    graph.edges.push_back(
        {find_vertex(graph.vertices, segment.a), find_vertex(graph.vertices, segment.b)});
    graph.edge_sources.push_back(ids);
  }
}

}  // namespace

Drawing to_doubles(const SegmentSet& input, const Options& options) {
  if (options.radius && !(std::isfinite(*options.radius) && *options.radius >= 0)) {
    throw Error(ErrorCode::BadInput, "the radius must be finite and not negative", {},
                shortest_text(*options.radius));
  }
  std::vector<PointD> ends, points;
  for (std::size_t i = 0; i < input.segments.size(); ++i) {
    const auto numbers = input.segments.numbers(i);
    ends.push_back(finite(NumberPoint{numbers[0], numbers[1]}, "segment", i));
    ends.push_back(finite(NumberPoint{numbers[2], numbers[3]}, "segment", i));
  }
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    points.push_back(finite(input.points[i], "point", i));
  }
  Drawing drawing;
  const double largest = std::max(largest_coordinate(ends), largest_coordinate(points));
  if (largest > 0 && std::abs(std::ilogb(largest)) > kLargestPlainExponent) {
    drawing.exponent = std::ilogb(largest);
  }
  for (PointD& p : ends) p = scaled(p, -drawing.exponent);
  for (PointD& p : points) p = scaled(p, -drawing.exponent);

  std::vector<SourcedSegment> segments;
  std::vector<PointD> used = points;
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    if (ends[i] == ends[i + 1]) continue;
    segments.push_back(
        {{std::min(ends[i], ends[i + 1]), std::max(ends[i], ends[i + 1])}, SegmentId(i / 2)});
    used.insert(used.end(), {ends[i], ends[i + 1]});
  }
  std::sort(segments.begin(), segments.end());
  drawing.graph.vertices = sorted_unique(std::move(used));
  append_distinct(drawing.graph, segments);
  for (const PointD& p : sorted_unique(std::move(points))) {
    const VertexId v = find_vertex(drawing.graph.vertices, p);
    drawing.graph.edges.push_back({v, v});
    drawing.graph.edge_sources.push_back(std::vector<SegmentId>{});
  }
  choose_radius(drawing, options);
  return drawing;
}

}  // namespace plumbline::lar

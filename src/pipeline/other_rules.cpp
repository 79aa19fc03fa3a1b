// What others do at one tolerance, beside the repair: short versions of rules in use, in doubles.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/point_d.hpp"
#include "geometry/point_tree.hpp"
#include "geometry/union_find.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/engines/lar.hpp"
#include "plumbline/pipeline.hpp"

namespace plumbline {
namespace {

/// An edge is nearly parallel to an axis within this ratio of its sides.
constexpr double kNearlyParallel = 0.05;

RuleOutcome measured(std::string rule, const ExactComplex& complex,
                     const std::vector<PointD>& authored) {
  RuleOutcome result;
  result.rule = std::move(rule);
  result.vertices = complex.vertices.size();
  result.edges = complex.edge_count();
  result.faces = complex.face_count() - 1;
  Rational area = 0;
  for (const Rational& of_face : face_areas(complex)) area += of_face;
  result.area = nearest_double(area);
  for (const Edge& edge : complex.edges) {
    const PointD p = complex.vertices.nearest(edge.tail), q = complex.vertices.nearest(edge.head);
    const double x = std::abs(q.x - p.x), y = std::abs(q.y - p.y);
    const double lesser = std::min(x, y);
    result.skewed += lesser > 0 && lesser < kNearlyParallel * std::max(x, y) ? 1 : 0;
  }
  const PointTree tree(authored);
  for (std::size_t v = 0; v < complex.vertices.size() && !authored.empty(); ++v) {
    const PointD p = complex.vertices.nearest(v);
    const auto near = tree.nearest(p, 1, std::numeric_limits<double>::infinity());
    const double away = distance(p, authored[near.front()]);
    if (!(away > 0)) continue;
    ++result.moved;
    result.furthest = std::max(result.furthest, away);
  }
  return result;
}

/// The ends of a drawing's segments, and which of them are loose.
struct LooseEnds {
  std::vector<SegmentD> segments;
  std::vector<PointD> points;                        ///< of the loose ends
  std::vector<std::pair<std::size_t, bool>> end_of;  ///< per point its segment, and whether b
};

LooseEnds loose_ends(const SegmentSet& input, const ExactComplex& complex) {
  std::vector<std::uint32_t> degree(complex.vertices.size());
  for (const Edge& edge : complex.edges) ++degree[edge.tail], ++degree[edge.head];
  LooseEnds result;
  for (const Segment& segment : input.segments) {
    for (const bool is_b : {false, true}) {
      const Point& p = is_b ? segment.b : segment.a;
      if (degree[complex.vertices.count_before(p)] != 1) continue;
      result.points.push_back(nearest(p));
      result.end_of.emplace_back(result.segments.size(), is_b);
    }
    result.segments.push_back({nearest(segment.a), nearest(segment.b)});
  }
  return result;
}

ExactComplex arranged(const std::vector<SegmentD>& segments) {
  SegmentSet set;
  const SourceId source = set.add_source({});
  for (const SegmentD& segment : segments) set.add(segment.a, segment.b, source);
  return arrange(set);
}

/// Loose ends no further apart than the tolerance, and so on along chains of them, go to their mean
/// (momepy's `close_gaps`).
ExactComplex with_closed_gaps(const LooseEnds& ends, double tolerance) {
  UnionFind sets(ends.points.size());
  const PointTree tree(ends.points);
  for (std::size_t i = 0; i < ends.points.size(); ++i) {
    tree.for_each_near(ends.points[i], tolerance, [&](std::size_t j) { sets.unite(i, j); });
  }
  struct Sum {
    double x = 0, y = 0, count = 0;
  };
  std::map<std::size_t, Sum> sums;
  for (std::size_t i = 0; i < ends.points.size(); ++i) {
    Sum& sum = sums[sets.find(i)];
    sum.x += ends.points[i].x;
    sum.y += ends.points[i].y;
    ++sum.count;
  }
  std::vector<SegmentD> segments = ends.segments;
  for (std::size_t i = 0; i < ends.points.size(); ++i) {
    const Sum& sum = sums[sets.find(i)];
    SegmentD& segment = segments[ends.end_of[i].first];
    (ends.end_of[i].second ? segment.b : segment.a) = {sum.x / sum.count, sum.y / sum.count};
  }
  return arranged(segments);
}

/// Every segment grows by the tolerance at both ends.
ExactComplex with_all_extended(const LooseEnds& ends, double tolerance) {
  std::vector<SegmentD> segments = ends.segments;
  for (SegmentD& s : segments) {
    const PointD d{s.b.x - s.a.x, s.b.y - s.a.y};
    const double part = tolerance / quick_length(d);
    s = {point_at(s, -part), point_at(s, 1 + part)};
  }
  return arranged(segments);
}

}  // namespace

std::vector<RuleOutcome> compare_rules(const SegmentSet& input, const Repair& repair,
                                       double tolerance) {
  const ExactComplex drawn = arrange(input);
  const std::vector<PointD> authored = nearest(drawn).vertices;
  const LooseEnds ends = loose_ends(input, drawn);
  return {measured("as drawn", drawn, authored),
          measured("repair", arrange(repair.output), authored),
          measured("LAR pruning", exact(lar::arrange(input, {tolerance, 0}).complex), authored),
          measured("close gaps", with_closed_gaps(ends, tolerance), authored),
          measured("extend all", with_all_extended(ends, tolerance), authored)};
}

}  // namespace plumbline

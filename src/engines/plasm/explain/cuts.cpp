#include "engines/plasm/explain/cuts.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/point_d.hpp"
#include "plumbline/engines/plasm_stages.hpp"

namespace plumbline::plasm {
namespace {

/// What is less, relatively, is rounding.
constexpr double kRounding = 0x1p-44;

SegmentD segment(const Graph& graph, std::size_t e) {
  return {graph.vertices[graph.edges[e][0]], graph.vertices[graph.edges[e][1]]};
}

/// By how much a parameter is outside of 0 to 1.
double excess(double parameter) { return std::max({0.0, -parameter, parameter - 1}); }

double distance_to_line(const PointD& p, const SegmentD& s) {
  const double x = s.b.x - s.a.x, y = s.b.y - s.a.y;
  return std::abs(x * (p.y - s.a.y) - y * (p.x - s.a.x)) / distance(s.a, s.b);
}

/// Where two edges meet that count as parallel, if they do.
std::optional<PointD> meeting_place(const SegmentD& first, const SegmentD& second) {
  const Segment a{exact(first.a), exact(first.b)}, b{exact(second.a), exact(second.b)};
  const int s = orientation(a.a, a.b, b.a), t = orientation(a.a, a.b, b.b);
  const int u = orientation(b.a, b.b, a.a), v = orientation(b.a, b.b, a.b);
  if ((s == 0 && t == 0) || s * t > 0 || u * v > 0) return std::nullopt;
  const double at_start = distance_to_line(first.a, second);
  const double at_end = distance_to_line(first.b, second);
  return point_at(first, at_start / (at_start + at_end));
}

std::optional<OddCut> odd_cut(const SegmentD& first, const SegmentD& second, double radius) {
  const Meeting meeting = meet(first, second, radius);
  if (meeting.kind == Meeting::Kind::Crossing) {
    const double length = distance(first.a, first.b), other = distance(second.a, second.b);
    const double away =
        std::max(excess(meeting.on_first) * length, excess(meeting.on_second) * other);
    if (meeting.cuts.empty() || away <= kRounding * (length + other)) return std::nullopt;
    return OddCut{OddCut::Kind::Reach, meeting.cuts[0].point, away, {}};
  }
  const std::optional<PointD> place = meeting_place(first, second);
  const Cut* furthest = nullptr;
  for (const Cut& cut : meeting.cuts) {
    const double away = distance_to_line(cut.point, first);
    if (away <= kRounding * distance(first.a, first.b)) continue;
    if (!furthest || away > distance_to_line(furthest->point, first)) furthest = &cut;
  }
  if (furthest) {
    return OddCut{
        OddCut::Kind::Collinear, furthest->point, distance_to_line(furthest->point, first), {}};
  }
  if (place) return OddCut{OddCut::Kind::Parallel, *place, 0, {}};
  return std::nullopt;
}

}  // namespace

OddCuts::OddCuts(const Trace& trace) {
  const Graph& graph = trace.drawing;
  const auto all_partners = partners(graph);
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    for (const EdgeId other : all_partners[e]) {
      auto odd = odd_cut(segment(graph, e), segment(graph, other), trace.radius);
      if (!odd) continue;
      for (const std::size_t edge : {e, static_cast<std::size_t>(other)}) {
        const auto sources = graph.edge_sources[edge];
        odd->segments.insert(odd->segments.end(), sources.begin(), sources.end());
      }
      cuts_.push_back(std::move(*odd));
    }
  }
}

const OddCut* OddCuts::nearest_to(const PointD& p, std::span<const SegmentId> segments) const {
  const OddCut* result = nullptr;
  std::pair<std::ptrdiff_t, double> least;
  for (const OddCut& cut : cuts_) {
    const auto shared = std::count_if(cut.segments.begin(), cut.segments.end(), [&](SegmentId s) {
      return std::find(segments.begin(), segments.end(), s) != segments.end();
    });
    if (shared == 0) continue;
    const std::pair<std::ptrdiff_t, double> key{-shared, distance(cut.where, p)};
    if (!result || key < least) {
      least = key;
      result = &cut;
    }
  }
  return result;
}

}  // namespace plumbline::plasm

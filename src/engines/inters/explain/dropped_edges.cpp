#include "engines/inters/explain/dropped_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/point_d.hpp"

namespace plumbline::inters {
namespace {

using lar::VertexPair;

/// Area of the box.
double extent(const Trace& trace, const std::vector<VertexPair>& component) {
  std::vector<PointD> points;
  for (const VertexPair& edge : component) {
    for (const VertexId v : edge) points.push_back(trace.lar.vertices[v]);
  }
  const BoxD box = box_of(points);
  return box.width() * box.height();
}

double distance(const PointD& p, const SegmentD& s) {
  const double x = s.b.x - s.a.x, y = s.b.y - s.a.y;
  const double squared = x * x + y * y;
  const double at =
      squared == 0 ? 0 : std::clamp(((p.x - s.a.x) * x + (p.y - s.a.y) * y) / squared, 0.0, 1.0);
  return plumbline::distance({s.a.x + at * x, s.a.y + at * y}, p);
}

}  // namespace

DroppedEdges::DroppedEdges(const Trace& trace, Result result, const EdgeSources& sources) {
  if (result == Result::CellsFromCycles) return;
  for (const VertexPair& edge : trace.bridges) add(trace, edge, Why::NoCycle, sources);
  if (result == Result::LarFromLines && !trace.components.empty()) {
    // The first of those with most edges is kept.
    const auto kept =
        std::max_element(trace.components.begin(), trace.components.end(),
                         [](const auto& a, const auto& b) { return a.size() < b.size(); });
    const double kept_extent = extent(trace, *kept);
    for (auto it = trace.components.begin(); it != trace.components.end(); ++it) {
      if (it == kept) continue;
      const Why why = extent(trace, *it) > kept_extent ? Why::LargerExtent : Why::FewerEdges;
      for (const VertexPair& edge : *it) add(trace, edge, why, sources);
    }
  }
  std::sort(by_segment_.begin(), by_segment_.end());
}

void DroppedEdges::add(const Trace& trace, const VertexPair& edge, Why why,
                       const EdgeSources& sources) {
  for (const SegmentId s : sources.at({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])})) {
    by_segment_.emplace_back(s, edges_.size());
  }
  edges_.push_back({{trace.lar.vertices[edge[0]], trace.lar.vertices[edge[1]]}, why});
}

std::optional<DroppedEdges::Why> DroppedEdges::nearest_to(
    const PointD& p, std::span<const SegmentId> segments) const {
  std::optional<Why> result;
  double least = std::numeric_limits<double>::infinity();
  for (const SegmentId s : segments) {
    for (auto it =
             std::lower_bound(by_segment_.begin(), by_segment_.end(), std::pair(s, std::size_t{0}));
         it != by_segment_.end() && it->first == s; ++it) {
      if (const double away = distance(p, edges_[it->second].segment); away < least) {
        least = away;
        result = edges_[it->second].why;
      }
    }
  }
  return result;
}

}  // namespace plumbline::inters

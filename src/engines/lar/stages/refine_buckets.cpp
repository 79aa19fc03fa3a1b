// Boxes of long slanted edges overlap although the edges are far apart: a hatching ends in one
// bucket. Turned by the edges' common direction their boxes are narrow.

#include <algorithm>
#include <cmath>

#include "plumbline/engines/lar_stages.hpp"

namespace plumbline::lar {
namespace {

/// Smaller buckets cost less to test than to turn.
constexpr std::size_t kFullBucket = 64;

struct Rotation {
  double cosine = 1, sine = 0;
  PointD operator()(const PointD& p) const {
    return {cosine * p.x + sine * p.y, cosine * p.y - sine * p.x};
  }
};

/// The turn that lays the edges' mean direction along x; directions are averaged by their doubled
/// angles, so that opposite ones agree.
Rotation along(const Graph& graph, std::span<const EdgeId> bucket) {
  double x = 0, y = 0;
  for (const EdgeId e : bucket) {
    const PointD& a = graph.vertices[graph.edges[e].tail];
    const PointD& b = graph.vertices[graph.edges[e].head];
    const double dx = b.x - a.x, dy = b.y - a.y;
    x += dx * dx - dy * dy;
    y += 2 * dx * dy;
  }
  const double angle = std::atan2(y, x) / 2;
  return {std::cos(angle), std::sin(angle)};
}

Lists<EdgeId> turned_buckets(const Graph& graph, std::span<const EdgeId> bucket, double margin) {
  const Rotation turned = along(graph, bucket);
  Graph turned_graph;
  for (const EdgeId e : bucket) {
    const std::size_t n = turned_graph.vertices.size();
    turned_graph.vertices.push_back(turned(graph.vertices[graph.edges[e].tail]));
    turned_graph.vertices.push_back(turned(graph.vertices[graph.edges[e].head]));
    turned_graph.edges.push_back({VertexId(n), VertexId(n + 1)});
  }
  return box_buckets(containment_boxes(turned_graph, margin));
}

std::size_t pairs(const Lists<EdgeId>& buckets) {
  std::size_t result = 0;
  for (std::size_t b = 0; b < buckets.size(); ++b) result += buckets[b].size() * buckets[b].size();
  return result;
}

}  // namespace

Lists<EdgeId> refine_buckets(const Graph& graph, const Lists<EdgeId>& buckets, double margin) {
  std::vector<std::vector<EdgeId>> refined;
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    const auto bucket = buckets[b];
    if (bucket.size() >= kFullBucket) {
      const Lists<EdgeId> parts = turned_buckets(graph, bucket, margin);
      if (2 * pairs(parts) <= bucket.size() * bucket.size()) {
        for (std::size_t i = 0; i < parts.size(); ++i) {
          refined.emplace_back();
          for (const EdgeId local : parts[i]) refined.back().push_back(bucket[local]);
        }
        continue;
      }
    }
    refined.emplace_back(bucket.begin(), bucket.end());
  }
  std::sort(refined.begin(), refined.end());
  refined.erase(std::unique(refined.begin(), refined.end()), refined.end());
  Lists<EdgeId> result;
  for (const std::vector<EdgeId>& bucket : refined) result.push_back(bucket);
  return result;
}

}  // namespace plumbline::lar

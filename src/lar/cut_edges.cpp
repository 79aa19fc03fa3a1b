// Brute force within the buckets. Each pair is met twice, once from each edge, so that only the
// cuts of one edge are in memory before those that rounding alone tells apart are dropped: a pencil
// of n lines has n^2 of them.

#include <algorithm>
#include <limits>

#include "lar/points.hpp"
#include "lar/stages.hpp"

namespace plumbline::lar {
namespace {

using BucketId = Index<struct BucketTag>;

bool meets(const Box& s, const Box& t) {
  return s[0] <= t[2] && t[0] <= s[2] && s[1] <= t[3] && t[1] <= s[3];
}

SegmentD segment(const Graph& graph, EdgeId e) {
  return {graph.vertices[graph.edges[e].tail], graph.vertices[graph.edges[e].head]};
}

std::vector<std::vector<BucketId>> buckets_of_edges(const Lists<EdgeId>& buckets,
                                                    std::size_t edges) {
  std::vector<std::vector<BucketId>> result(edges);
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    for (EdgeId e : buckets[b]) result[e].push_back(BucketId(b));
  }
  return result;
}

/// Sorts, and drops what lies within `same` of the one kept before, or further from it than the
/// edge is long: two ends beside a short edge, one on each side, would replace it by their
/// connection, and next time that by the edge.
void reduce(std::vector<Cut>& cuts, const SegmentD& edge, double same) {
  std::sort(cuts.begin(), cuts.end(), [](const Cut& s, const Cut& t) {
    return s.parameter != t.parameter ? s.parameter < t.parameter : s.point < t.point;
  });
  const double length = squared_distance(edge.a, edge.b);
  std::vector<Cut> kept;
  for (const Cut& cut : cuts) {
    const bool superfluous =
        !kept.empty() && (near(kept.back().point, cut.point, same) ||
                          squared_distance(kept.back().point, cut.point) >= length);
    if (!superfluous) kept.push_back(cut);
  }
  cuts = std::move(kept);
}

}  // namespace

Lists<Cut> cut_edges(const Graph& graph, std::span<const Box> boxes, const Lists<EdgeId>& buckets,
                     double radius) {
  const double same = kLeastRelativeRadius / 4 * largest_coordinate(graph.vertices);
  const auto memberships = buckets_of_edges(buckets, graph.edges.size());
  std::vector<EdgeId> met_by(graph.edges.size());
  Lists<Cut> result;
  std::vector<Cut> cuts;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const EdgeId e(i);
    cuts.clear();
    met_by[e] = e;
    for (BucketId b : memberships[e]) {
      for (EdgeId other : buckets[b]) {
        if (met_by[other] == e) continue;
        met_by[other] = e;
        if (!meets(boxes[e], boxes[other])) continue;
        const Meeting meeting =
            meet(segment(graph, std::min(e, other)), segment(graph, std::max(e, other)), radius);
        const std::vector<Cut>& mine = e < other ? meeting.on_first : meeting.on_second;
        cuts.insert(cuts.end(), mine.begin(), mine.end());
      }
    }
    reduce(cuts, segment(graph, e), same);
    result.push_back(cuts);
  }
  return result;
}

}  // namespace plumbline::lar

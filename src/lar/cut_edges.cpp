// Brute force within the buckets. Each pair is met twice, once from each edge, so that only the
// cuts of one edge are in memory before those that rounding alone tells apart are dropped: a pencil
// of n lines has n^2 of them.

#include <algorithm>

#include "lar/points.hpp"
#include "lar/stages.hpp"

namespace plumbline::lar {
namespace {

using BucketId = Index<struct BucketTag>;

bool overlap(const Box& s, const Box& t) {
  return s[0] <= t[2] && t[0] <= s[2] && s[1] <= t[3] && t[1] <= s[3];
}

std::vector<SegmentD> segments_of(const Graph& graph) {
  std::vector<SegmentD> segments;
  segments.reserve(graph.edges.size());
  for (const auto& [tail, head] : graph.edges) {
    segments.push_back({graph.vertices[tail], graph.vertices[head]});
  }
  return segments;
}

/// The edges whose boxes overlap, through the buckets that they share.
class Neighbours {
 public:
  Neighbours(std::span<const Box> boxes, const Lists<EdgeId>& buckets)
      : boxes_(boxes), buckets_(buckets), buckets_of_(boxes.size()), visited_by_(boxes.size()) {
    for (std::size_t b = 0; b < buckets.size(); ++b) {
      for (EdgeId e : buckets[b]) buckets_of_[e].push_back(BucketId(b));
    }
  }

  /// Calls visit(other) once for each.
  template <class Visit>
  void for_each(EdgeId e, Visit visit) {
    visited_by_[e] = e;
    for (BucketId b : buckets_of_[e]) {
      for (EdgeId other : buckets_[b]) {
        if (visited_by_[other] == e) continue;
        visited_by_[other] = e;
        if (overlap(boxes_[e], boxes_[other])) visit(other);
      }
    }
  }

 private:
  std::span<const Box> boxes_;
  const Lists<EdgeId>& buckets_;
  std::vector<std::vector<BucketId>> buckets_of_;
  std::vector<EdgeId> visited_by_;
};

/// Sorts, and drops what lies within `same` of the one kept before, or further from it than the
/// edge is long: two ends beside a short edge, one on each side, would replace it by their
/// connection, and next time that by the edge.
std::vector<Cut> reduced(std::vector<Cut> cuts, const SegmentD& edge, double same) {
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
  return kept;
}

}  // namespace

Lists<Cut> cut_edges(const Graph& graph, std::span<const Box> boxes, const Lists<EdgeId>& buckets,
                     double radius) {
  const double same = kLeastRelativeRadius / 4 * largest_coordinate(graph.vertices);
  const std::vector<SegmentD> segments = segments_of(graph);
  Neighbours neighbours(boxes, buckets);
  Lists<Cut> result;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const EdgeId e(i);
    const SegmentD& edge = segments[e];
    std::vector<Cut> cuts;
    // An edge no longer than the radius will become a point: no place on it is worth a cut, and
    // where it crosses another such edge some of their ends are near each other.
    const bool vanishes = near(edge.a, edge.b, radius);
    if (!vanishes) {
      neighbours.for_each(e, [&](EdgeId other) {
        const SegmentD& partner = segments[other];
        const Meeting meeting =
            e < other ? meet(edge, partner, radius) : meet(partner, edge, radius);
        for (const Cut& cut : e < other ? meeting.on_first : meeting.on_second) {
          if (cuts.empty() || !near(cuts.back().point, cut.point, same)) cuts.push_back(cut);
        }
      });
    }
    result.push_back(reduced(std::move(cuts), edge, same));
  }
  return result;
}

}  // namespace plumbline::lar

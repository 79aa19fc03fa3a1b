// Brute force within the buckets, in parallel: buckets are independent, and so are the rows of a
// full one. Of cuts that rounding alone tells apart most are dropped at once: a pencil of n lines
// has n^2 of them. Where its crossings are further apart, as in a jittered one, all count.

#include <algorithm>
#include <atomic>

#include "engines/lar/stages/bucket_pairs.hpp"
#include "engines/lar/stages/parallel.hpp"
#include "engines/lar/stages/points.hpp"
#include "plumbline/engines/lar_stages.hpp"
#include "plumbline/error.hpp"

namespace plumbline::lar {
namespace {

constexpr std::size_t kEdgesPerBlock = 4096;
/// Members that rows are paired with before the next ones: they fit the processor's first cache.
constexpr std::size_t kMembersAtOnce = 256;

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

struct EdgeCut {
  EdgeId edge;
  Cut cut;
};

/// How many cuts all tasks may find together. Whether they find more does not depend on their
/// order.
class Allowance {
 public:
  explicit Allowance(std::size_t most) : most_(most) {}
  /// Throws: Error Limit.
  void take(std::size_t cuts) {
    if (taken_.fetch_add(cuts, std::memory_order_relaxed) + cuts <= most_) return;
    throw Error(ErrorCode::Limit, "the edges cut each other in too many places");
  }

 private:
  std::size_t most_;
  std::atomic<std::size_t> taken_{0};
};

/// Cuts as a task finds them.
class FoundCuts {
 public:
  FoundCuts(double same, Allowance& allowance) : same_(same), allowance_(allowance) {}

  /// Before the members of another bucket are cut.
  void begin_bucket(std::size_t members) { last_.assign(members, kNone); }
  /// Cuts an edge, which stands at that position in the bucket; unless it was last cut there.
  void add(std::size_t position, EdgeId e, const CutPair& cuts) {
    for (const Cut& cut : cuts) {
      std::size_t& last = last_[position];
      if (last != kNone && near(cuts_[last].cut.point, cut.point, same_)) continue;
      last = cuts_.size();
      cuts_.push_back({e, cut});
    }
  }
  /// After a bounded number of pairs.
  void count() {
    allowance_.take(cuts_.size() - counted_);
    counted_ = cuts_.size();
  }
  std::vector<EdgeCut> take() { return std::move(cuts_); }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  double same_;
  Allowance& allowance_;
  std::size_t counted_ = 0;
  std::vector<std::size_t> last_;  ///< per position
  std::vector<EdgeCut> cuts_;
};

/// What cutting needs to know of a drawing.
struct Edges {
  std::vector<SegmentD> segments;
  std::span<const Box> boxes;
  std::vector<bool> vanishes;  ///< no longer than the radius: will become a point
  double radius;
  double same;  ///< cuts no further apart than this differ by rounding
};

/// Cuts the rows' members and some members behind them.
void cut_pairs(const BucketPairs::Rows& rows, std::size_t first, std::size_t last,
               const BucketPairs& pairs, const Edges& edges, FoundCuts& found) {
  const auto bucket = pairs.bucket(rows.bucket);
  for (std::size_t row = rows.begin; row < rows.end; ++row) {
    const EdgeId e = bucket[row];
    for (std::size_t i = std::max(first, row + 1); i < last; ++i) {
      const EdgeId other = bucket[i];
      if (!overlap(edges.boxes[e], edges.boxes[other])) continue;
      if (!pairs.is_first_common(rows.bucket, e, other)) continue;
      const Meeting meeting = meet(edges.segments[e], edges.segments[other], edges.radius);
      // No place on an edge that vanishes is worth a cut, and where it crosses another such edge
      // some of their ends are near each other.
      if (!edges.vanishes[e]) found.add(row, e, meeting.on_first);
      if (!edges.vanishes[other]) found.add(i, other, meeting.on_second);
    }
  }
}

std::vector<EdgeCut> cuts_of(std::span<const BucketPairs::Rows> task, const BucketPairs& pairs,
                             const Edges& edges, Allowance& allowance) {
  FoundCuts found(edges.same, allowance);
  for (const BucketPairs::Rows& rows : task) {
    const std::size_t members = pairs.bucket(rows.bucket).size();
    found.begin_bucket(members);
    for (std::size_t first = rows.begin; first < members; first += kMembersAtOnce) {
      cut_pairs(rows, first, std::min(members, first + kMembersAtOnce), pairs, edges, found);
      found.count();
    }
  }
  return found.take();
}

/// Sorts, and drops what lies within `same` of the one kept before, or further from it than the
/// edge is long: two ends beside a short edge, one on each side, would replace it by their
/// connection, and next time that by the edge. Returns how many are left.
std::size_t reduce(std::span<Cut> cuts, const SegmentD& edge, double same) {
  std::sort(cuts.begin(), cuts.end(), [](const Cut& s, const Cut& t) {
    return s.parameter != t.parameter ? s.parameter < t.parameter : s.point < t.point;
  });
  const double length = squared_distance(edge.a, edge.b);
  std::size_t kept = 0;
  for (const Cut& cut : cuts) {
    const bool superfluous =
        kept > 0 && (near(cuts[kept - 1].point, cut.point, same) ||
                     squared_distance(cuts[kept - 1].point, cut.point) >= length);
    if (!superfluous) cuts[kept++] = cut;
  }
  return kept;
}

/// The cuts edge by edge.
Lists<Cut> gathered(const std::vector<std::vector<EdgeCut>>& found, const Edges& edges) {
  std::vector<std::size_t> begin(edges.segments.size() + 1, 0);
  for (const auto& cuts : found) {
    for (const EdgeCut& c : cuts) ++begin[c.edge + 1];
  }
  for (std::size_t e = 0; e + 1 < begin.size(); ++e) begin[e + 1] += begin[e];
  std::vector<Cut> cuts(begin.back());
  std::vector<std::size_t> end(begin.begin(), begin.end() - 1);
  for (const auto& of_task : found) {
    for (const EdgeCut& c : of_task) cuts[end[c.edge]++] = c.cut;
  }
  for_blocks(end.size(), kEdgesPerBlock, [&](std::size_t first, std::size_t last) {
    for (std::size_t e = first; e < last; ++e) {
      const std::span<Cut> of_edge(cuts.data() + begin[e], cuts.data() + end[e]);
      end[e] = begin[e] + reduce(of_edge, edges.segments[e], edges.same);
    }
  });
  Lists<Cut> result;
  for (std::size_t e = 0; e < end.size(); ++e) {
    result.push_back(std::span<const Cut>(cuts.data() + begin[e], cuts.data() + end[e]));
  }
  return result;
}

}  // namespace

Lists<Cut> cut_edges(const Graph& graph, std::span<const Box> boxes, const Lists<EdgeId>& buckets,
                     double radius, std::size_t max_cuts) {
  Edges edges{segments_of(graph),
              boxes,
              {},
              radius,
              kLeastRelativeRadius / 4 * largest_coordinate(graph.vertices)};
  for (const SegmentD& s : edges.segments) edges.vanishes.push_back(near(s.a, s.b, radius));
  const BucketPairs pairs(graph.edges.size(), buckets);
  Allowance allowance(max_cuts);
  std::vector<std::vector<EdgeCut>> found(pairs.task_count());
  for_blocks(found.size(), 1, [&](std::size_t task, std::size_t) {
    found[task] = cuts_of(pairs.task(task), pairs, edges, allowance);
  });
  return gathered(found, edges);
}

}  // namespace plumbline::lar

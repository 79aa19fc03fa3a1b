// Duplicates: segments sorted by their ends. Overlaps: segments that share an edge are on one line,
// where they are intervals; pairs are counted by sorting, listed up to a bound.

#include <algorithm>

#include "diagnose/steps.hpp"
#include "geometry/union_find.hpp"

namespace plumbline::diagnose_steps {
namespace {

// Pairs of overlapping segments that are looked at for the longest ones; of k segments that cover
// each other there are k^2 / 2.
constexpr std::size_t kMostPairs = 200'000;

/// A segment's ends, lexicographically first one first.
struct Ends {
  NumberPoint low, high;
};

std::strong_ordering compare(const NumberPoint& p, const NumberPoint& q) {
  const auto by_x = p.x <=> q.x;
  return by_x != 0 ? by_x : p.y <=> q.y;
}
std::strong_ordering compare(const Ends& a, const Ends& b) {
  const auto by_low = compare(a.low, b.low);
  return by_low != 0 ? by_low : compare(a.high, b.high);
}

Point exact(const NumberPoint& p) { return {p.x.rational(), p.y.rational()}; }

std::vector<Ends> ends_of(const SegmentSet& input) {
  std::vector<Ends> ends;
  ends.reserve(input.segments.size());
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const auto n = input.segments.numbers(s);
    NumberPoint a{n[0], n[1]}, b{n[2], n[3]};
    if (compare(b, a) < 0) std::swap(a, b);
    ends.push_back({std::move(a), std::move(b)});
  }
  return ends;
}

/// The segments that have their ends in common with others, a list for each pair of ends.
Lists<SegmentId> equal_segments(const std::vector<Ends>& ends) {
  std::vector<SegmentId> order;
  for (std::size_t s = 0; s < ends.size(); ++s) order.emplace_back(s);
  std::sort(order.begin(), order.end(), [&](SegmentId s, SegmentId t) {
    const auto by_ends = compare(ends[s], ends[t]);
    return by_ends != 0 ? by_ends < 0 : s < t;
  });
  Lists<SegmentId> groups;
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && compare(ends[order[i]], ends[order[end]]) == 0) ++end;
    if (end - i > 1) groups.push_back(std::span(order).subspan(i, end - i));
    i = end;
  }
  return groups;
}

/// Per segment, the first one with the same ends.
std::vector<SegmentId> first_of_equal(std::size_t segments, const Lists<SegmentId>& equal) {
  std::vector<SegmentId> first;
  for (std::size_t s = 0; s < segments; ++s) first.emplace_back(s);
  for (std::size_t g = 0; g < equal.size(); ++g) {
    for (const SegmentId s : equal[g]) first[s] = equal[g].front();
  }
  return first;
}

/// The distinct segments by the connected parts of lines that several of them cover, each list in
/// the order of the ends.
std::vector<std::vector<SegmentId>> overlapping_groups(const std::vector<Ends>& ends,
                                                       const std::vector<SegmentId>& first,
                                                       const Lists<SegmentId>& edge_sources) {
  UnionFind sets(ends.size());
  for (std::size_t s = 0; s < first.size(); ++s) sets.unite(s, first[s]);
  for (std::size_t e = 0; e < edge_sources.size(); ++e) {
    for (const SegmentId s : edge_sources[e]) sets.unite(s, edge_sources[e][0]);
  }
  std::vector<std::vector<SegmentId>> groups(ends.size());
  for (std::size_t s = 0; s < ends.size(); ++s) {
    if (first[s] == SegmentId(s)) groups[sets.find(s)].emplace_back(s);
  }
  std::erase_if(groups, [](const auto& group) { return group.size() < 2; });
  for (std::vector<SegmentId>& group : groups) {
    std::sort(group.begin(), group.end(),
              [&](SegmentId s, SegmentId t) { return compare(ends[s], ends[t]) < 0; });
  }
  return groups;
}

/// Pairs of a group that overlap: of each segment those that start before it and do not end before
/// it starts.
std::size_t pair_count(const std::vector<Ends>& ends, const std::vector<SegmentId>& group) {
  std::vector<SegmentId> by_end = group;
  std::sort(by_end.begin(), by_end.end(),
            [&](SegmentId s, SegmentId t) { return compare(ends[s].high, ends[t].high) < 0; });
  std::size_t pairs = 0, ended = 0;
  for (std::size_t i = 0; i < group.size(); ++i) {
    while (compare(ends[by_end[ended]].high, ends[group[i]].low) <= 0) ++ended;
    pairs += i - ended;
  }
  return pairs;
}

Defect repeated(DefectKind kind, const Point& a, const Point& b, std::vector<SegmentId> segments) {
  Defect defect;
  defect.kind = kind;
  defect.where = midpoint(a, b);
  defect.squared_size = squared_distance(a, b);
  defect.size = nearest_sqrt(*defect.squared_size);
  defect.proposed_tolerance = 0;
  defect.segments = std::move(segments);
  std::sort(defect.segments.begin(), defect.segments.end());
  return defect;
}

/// The first `count` pairs of the group.
void list_pairs(const std::vector<Ends>& ends, const std::vector<SegmentId>& group,
                std::size_t count, Defects& defects) {
  for (std::size_t i = 0; i < group.size(); ++i) {
    for (std::size_t j = i + 1; j < group.size(); ++j) {
      const Ends &a = ends[group[i]], &b = ends[group[j]];
      if (compare(b.low, a.high) >= 0) break;
      if (count-- == 0) return;
      const NumberPoint& end = compare(a.high, b.high) < 0 ? a.high : b.high;
      defects.add(repeated(DefectKind::Overlap, exact(b.low), exact(end), {group[i], group[j]}));
    }
  }
}

}  // namespace

Defects duplicates_and_overlaps(const Subject& subject) {
  const std::vector<Ends> ends = ends_of(subject.input);
  const Lists<SegmentId> equal = equal_segments(ends);
  Defects defects(subject.most_listed);
  for (std::size_t g = 0; g < equal.size(); ++g) {
    const Ends& common = ends[equal[g].front()];
    defects.add(repeated(DefectKind::Duplicate, exact(common.low), exact(common.high),
                         {equal[g].begin(), equal[g].end()}));
  }
  std::size_t looked_at = 0;
  for (const std::vector<SegmentId>& group : overlapping_groups(
           ends, first_of_equal(ends.size(), equal), subject.graph.complex().edge_sources)) {
    const std::size_t pairs = pair_count(ends, group);
    const std::size_t listed = std::min(pairs, kMostPairs - std::min(kMostPairs, looked_at));
    list_pairs(ends, group, listed, defects);
    looked_at += listed;
    defects.add_unlisted(DefectKind::Overlap, pairs - listed, 0);
  }
  return defects;
}

}  // namespace plumbline::diagnose_steps

namespace plumbline {

Repetitions repetitions(const SegmentSet& input, const ExactComplex& complex) {
  using namespace diagnose_steps;
  const std::vector<Ends> ends = ends_of(input);
  const Lists<SegmentId> equal = equal_segments(ends);
  Repetitions result;
  result.duplicates = equal.flat().size() - equal.size();
  for (const auto& group :
       overlapping_groups(ends, first_of_equal(ends.size(), equal), complex.edge_sources)) {
    result.overlaps += pair_count(ends, group);
  }
  return result;
}

}  // namespace plumbline

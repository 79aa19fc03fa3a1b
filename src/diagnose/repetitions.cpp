// Duplicates: segments sorted by their ends. Overlaps: segments that share an edge are on one line,
// where they are intervals; pairs are counted by sorting, listed up to a bound. What two closed
// shapes have in common as neighbours is neither.

#include <algorithm>

#include "diagnose/sides.hpp"
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

/// Pairs of a group that are defects, and those that are sides of neighbours.
struct PairCounts {
  std::size_t defects = 0, shared = 0;
};
PairCounts pair_counts(const std::vector<Ends>& ends, const std::vector<SegmentId>& group,
                       const std::vector<SideOf>& sides) {
  std::vector<SegmentId> left, right, both;
  for (const SegmentId s : group) {
    if (sides[s].side == Side::Left) left.push_back(s);
    if (sides[s].side == Side::Right) right.push_back(s);
    if (sides[s].side != Side::Unknown) both.push_back(s);
  }
  PairCounts counts;
  if (!left.empty() && !right.empty()) {
    counts.shared = pair_count(ends, both) - pair_count(ends, left) - pair_count(ends, right);
  }
  counts.defects = pair_count(ends, group) - counts.shared;
  return counts;
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

/// Those among the first `most` pairs of the group that are defects; how many these are.
std::size_t list_pairs(const std::vector<Ends>& ends, const std::vector<SegmentId>& group,
                       const std::vector<SideOf>& sides, std::size_t most, Defects& defects) {
  std::size_t listed = 0;
  for (std::size_t i = 0; i < group.size(); ++i) {
    for (std::size_t j = i + 1; j < group.size(); ++j) {
      const Ends &a = ends[group[i]], &b = ends[group[j]];
      if (compare(b.low, a.high) >= 0) break;
      if (most-- == 0) return listed;
      if (are_neighbours(sides[group[i]], sides[group[j]])) continue;
      const NumberPoint& end = compare(a.high, b.high) < 0 ? a.high : b.high;
      defects.add(repeated(DefectKind::Overlap, exact(b.low), exact(end), {group[i], group[j]}));
      ++listed;
    }
  }
  return listed;
}

/// All that is drawn twice: segments with equal ends in groups, those that overlap by line, and on
/// which side of each segment its shape lies.
class Repeated {
 public:
  Repeated(const SegmentSet& input, const ExactComplex& complex)
      : ends_(ends_of(input)), equal_(equal_segments(ends_)), sides_(sides_of(input)) {
    const std::vector<SegmentId> first = first_of_equal(ends_.size(), equal_);
    overlapping_ = overlapping_groups(ends_, first, complex.edge_sources);
    for (std::size_t g = 0; g < equal_.size(); ++g) {
      is_shared_.push_back(is_shared_side(equal_[g]));
      const SideOf one = sides_[equal_[g].front()];
      const auto differs = [&](SegmentId s) { return sides_[s].side != one.side; };
      // Of several the first one speaks for all.
      if (std::any_of(equal_[g].begin(), equal_[g].end(), differs)) sides_[equal_[g].front()] = {};
    }
    for (const std::vector<SegmentId>& group : overlapping_) forget_own(group);
  }

  const std::vector<Ends>& ends() const { return ends_; }
  const Lists<SegmentId>& equal() const { return equal_; }
  bool is_shared(std::size_t group) const { return is_shared_[group]; }
  const std::vector<std::vector<SegmentId>>& overlapping() const { return overlapping_; }
  const std::vector<SideOf>& sides() const { return sides_; }

 private:
  bool is_shared_side(std::span<const SegmentId> equal) const {
    return equal.size() == 2 && are_neighbours(sides_[equal[0]], sides_[equal[1]]);
  }

  /// A polygon that is on both sides of a line is no neighbour of itself: nothing there is one.
  void forget_own(const std::vector<SegmentId>& group) {
    std::vector<std::pair<std::uint32_t, Side>> polygons;
    for (const SegmentId s : group) {
      if (sides_[s].side != Side::Unknown) polygons.emplace_back(sides_[s].polygon, sides_[s].side);
    }
    std::sort(polygons.begin(), polygons.end());
    for (std::size_t i = 1; i < polygons.size(); ++i) {
      if (polygons[i].first != polygons[i - 1].first || polygons[i] == polygons[i - 1]) continue;
      for (const SegmentId s : group) sides_[s] = {};
      return;
    }
  }

  std::vector<Ends> ends_;
  Lists<SegmentId> equal_;
  std::vector<SideOf> sides_;  ///< of equal segments the first one's is that of all
  std::vector<bool> is_shared_;
  std::vector<std::vector<SegmentId>> overlapping_;
};

}  // namespace

Defects duplicates_and_overlaps(const Subject& subject) {
  const Repeated repetitions(subject.input, subject.graph.complex());
  const std::vector<Ends>& ends = repetitions.ends();
  Defects defects(subject.most_listed);
  for (std::size_t g = 0; g < repetitions.equal().size(); ++g) {
    if (repetitions.is_shared(g)) continue;
    const auto equal = repetitions.equal()[g];
    const Ends& common = ends[equal.front()];
    defects.add(repeated(DefectKind::Duplicate, exact(common.low), exact(common.high),
                         {equal.begin(), equal.end()}));
  }
  std::size_t looked_at = 0;
  for (const std::vector<SegmentId>& group : repetitions.overlapping()) {
    const PairCounts pairs = pair_counts(ends, group, repetitions.sides());
    const std::size_t most =
        std::min(pairs.defects + pairs.shared, kMostPairs - std::min(kMostPairs, looked_at));
    const std::size_t listed = list_pairs(ends, group, repetitions.sides(), most, defects);
    looked_at += most;
    defects.add_unlisted(DefectKind::Overlap, pairs.defects - listed, 0);
  }
  return defects;
}

}  // namespace plumbline::diagnose_steps

namespace plumbline {

Repetitions repetitions(const SegmentSet& input, const ExactComplex& complex) {
  using namespace diagnose_steps;
  const Repeated found(input, complex);
  Repetitions result;
  for (std::size_t g = 0; g < found.equal().size(); ++g) {
    if (found.is_shared(g)) {
      ++result.shared_sides;
    } else {
      result.duplicates += found.equal()[g].size() - 1;
    }
  }
  for (const auto& group : found.overlapping()) {
    const PairCounts pairs = pair_counts(found.ends(), group, found.sides());
    result.overlaps += pairs.defects;
    result.shared_sides += pairs.shared;
  }
  return result;
}

}  // namespace plumbline

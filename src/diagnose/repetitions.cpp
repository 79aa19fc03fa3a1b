// Duplicates: segments sorted by their ends. Overlaps: segments that share an edge are on one line,
// where they are intervals; pairs are counted by sorting, listed up to a bound.

#include <algorithm>
#include <numeric>

#include "diagnose/steps.hpp"

namespace plumbline::diagnosing {
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

class Repetitions {
 public:
  explicit Repetitions(const Work& work)
      : work_(work), result_(work.most_listed), first_(work.input.segments.size()) {
    ends_.reserve(first_.size());
    for (std::size_t s = 0; s < first_.size(); ++s) {
      const auto n = work.input.segments.numbers(s);
      NumberPoint a{n[0], n[1]}, b{n[2], n[3]};
      if (compare(b, a) < 0) std::swap(a, b);
      ends_.push_back({std::move(a), std::move(b)});
    }
  }

  Defects take() && { return std::move(result_); }

  void find_duplicates() {
    std::vector<SegmentId> order;
    for (std::size_t s = 0; s < ends_.size(); ++s) order.emplace_back(s);
    std::sort(order.begin(), order.end(), [&](SegmentId s, SegmentId t) {
      const auto by_ends = compare(ends_[s], ends_[t]);
      return by_ends != 0 ? by_ends < 0 : s < t;
    });
    for (std::size_t i = 0; i < order.size();) {
      std::size_t end = i;
      for (; end < order.size() && compare(ends_[order[i]], ends_[order[end]]) == 0; ++end)
        first_[order[end]] = order[i];
      if (end - i > 1)
        add(DefectKind::Duplicate, exact(ends_[order[i]].low), exact(ends_[order[i]].high),
            {order.begin() + static_cast<std::ptrdiff_t>(i),
             order.begin() + static_cast<std::ptrdiff_t>(end)});
      i = end;
    }
  }

  /// Requires: find_duplicates was called.
  void find_overlaps() {
    for (std::vector<SegmentId>& group : overlapping_groups()) {
      std::sort(group.begin(), group.end(),
                [&](SegmentId s, SegmentId t) { return compare(ends_[s], ends_[t]) < 0; });
      const std::size_t pairs = pair_count(group);
      const std::size_t listed = std::min(pairs, kMostPairs - std::min(kMostPairs, looked_at_));
      list_pairs(group, listed);
      looked_at_ += listed;
      result_.add_unlisted(DefectKind::Overlap, pairs - listed, 0);
    }
  }

 private:
  void add(DefectKind kind, const Point& a, const Point& b, std::vector<SegmentId> segments) {
    Defect defect;
    defect.kind = kind;
    defect.where = midpoint(a, b);
    defect.squared_size = squared_distance(a, b);
    defect.size = nearest_sqrt(*defect.squared_size);
    defect.proposed_tolerance = 0;
    defect.segments = std::move(segments);
    std::sort(defect.segments.begin(), defect.segments.end());
    result_.add(std::move(defect));
  }

  /// The distinct segments, by the connected parts of lines that several of them cover.
  std::vector<std::vector<SegmentId>> overlapping_groups() const {
    std::vector<SegmentId> parent = first_;
    const auto root = [&](SegmentId s) {
      while (parent[s] != s) s = parent[s] = parent[parent[s]];
      return s;
    };
    const Lists<SegmentId>& sources = work_.graph.complex().edge_sources;
    for (std::size_t e = 0; e < sources.size(); ++e)
      for (const SegmentId s : sources[e]) {
        const SegmentId a = root(s), b = root(sources[e][0]);
        parent[std::max(a, b)] = std::min(a, b);
      }
    std::vector<std::vector<SegmentId>> groups(parent.size());
    for (std::size_t s = 0; s < parent.size(); ++s)
      if (first_[s] == SegmentId(s)) groups[root(SegmentId(s))].emplace_back(s);
    std::erase_if(groups, [](const auto& group) { return group.size() < 2; });
    return groups;
  }

  /// Pairs that overlap: of each segment those that start before it and do not end before it
  /// starts.
  std::size_t pair_count(const std::vector<SegmentId>& group) const {
    std::vector<SegmentId> by_end = group;
    std::sort(by_end.begin(), by_end.end(),
              [&](SegmentId s, SegmentId t) { return compare(ends_[s].high, ends_[t].high) < 0; });
    std::size_t pairs = 0, ended = 0;
    for (std::size_t i = 0; i < group.size(); ++i) {
      while (compare(ends_[by_end[ended]].high, ends_[group[i]].low) <= 0) ++ended;
      pairs += i - ended;
    }
    return pairs;
  }

  void list_pairs(const std::vector<SegmentId>& group, std::size_t count) {
    for (std::size_t i = 0; i < group.size(); ++i)
      for (std::size_t j = i + 1; j < group.size(); ++j) {
        const Ends &a = ends_[group[i]], &b = ends_[group[j]];
        if (compare(b.low, a.high) >= 0) break;
        if (count-- == 0) return;
        const NumberPoint& end = compare(a.high, b.high) < 0 ? a.high : b.high;
        add(DefectKind::Overlap, exact(b.low), exact(end), {group[i], group[j]});
      }
  }

  const Work& work_;
  Defects result_;
  std::vector<Ends> ends_;
  std::vector<SegmentId> first_;  ///< per segment, the first one with the same ends
  std::size_t looked_at_ = 0;
};

}  // namespace

Defects duplicates_and_overlaps(const Work& work) {
  Repetitions repetitions(work);
  repetitions.find_duplicates();
  repetitions.find_overlaps();
  return std::move(repetitions).take();
}

}  // namespace plumbline::diagnosing

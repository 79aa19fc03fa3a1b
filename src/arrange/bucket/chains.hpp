#pragma once

// Step 5: the meetings of each line, sorted along it; meetings at the same point become one vertex.

#include <algorithm>
#include <span>
#include <vector>

#include "arrange/bucket/pairs.hpp"
#include "arrange/bucket/union_find.hpp"

namespace plumbline::bucket {

/// The chain of vertices of each line, from its first end to its last; and of each vertex the least
/// of its meetings.
struct Chains {
  Grouped<std::uint32_t> vertices;  ///< per line
  std::vector<MeetingId> meeting;   ///< per vertex
  std::span<const std::uint32_t> operator[](LineId line) const { return vertices[line]; }
};

/// The order of meetings on the same line. **Exact**.
template <class Kernel>
class OrderOnLine {
 public:
  OrderOnLine(const Kernel& kernel, const std::vector<Crossing>& crossings)
      : kernel_(kernel),
        crossings_(crossings),
        first_crossing_(static_cast<MeetingId>(2 * kernel.size())) {}

  bool is_end(MeetingId m) const { return m < first_crossing_; }
  const Crossing& crossing(MeetingId m) const { return crossings_[m - first_crossing_]; }
  /// A line that cuts s in meeting m, a crossing that s goes through.
  LineId cutter(LineId s, MeetingId m) const {
    const Crossing& c = crossing(m);
    if (c.s == s) return c.o;
    if (c.o == s) return c.s;
    return kernel_.compare_directions(s, c.s) != 0 ? c.s : c.o;
  }

  /// Order of two meetings along s.
  int compare(LineId s, MeetingId m, MeetingId n) const {
    return m == n ? 0 : compare_places(kernel_, s, place(s, m), place(s, n));
  }
  /// Order of a meeting on s and another place on it.
  int compare(LineId s, MeetingId m, const Place& p) const {
    return compare_places(kernel_, s, place(s, m), p);
  }

  /// Order of the x coordinates of a meeting on s and an end.
  int compare_x(LineId s, MeetingId m, EndId e) const {
    return is_end(m) ? kernel_.compare_x(m, e) : kernel_.compare_x(s, cutter(s, m), e);
  }

 private:
  Place place(LineId s, MeetingId m) const {
    return is_end(m) ? Place{m, kNone} : Place{kNone, cutter(s, m)};
  }

  const Kernel& kernel_;
  const std::vector<Crossing>& crossings_;
  MeetingId first_crossing_;
};

/// A meeting on a line, strictly between its ends.
struct Hit {
  double at;
  MeetingId meeting;
};

/// The crossings of all blocks.
inline std::vector<Crossing> gather_crossings(const std::vector<Meetings>& found, Job& job) {
  std::vector<std::size_t> begin;
  for (const Meetings& block : found) begin.push_back(block.crossings.size());
  accumulate(begin);
  std::vector<Crossing> crossings(begin.back());
  job.for_blocks(found.size(), 1, [&](std::size_t b, std::size_t) {
    for (std::size_t k = 0; k < found[b].crossings.size(); ++k) {
      crossings[begin[b] + k] = found[b].crossings[k].lines;
    }
  });
  return crossings;
}

/// Calls visit(line, at, meeting) for each hit found in a block whose first crossing is meeting
/// `first`.
template <class Visit>
void for_hits(const Meetings& found, MeetingId first, Visit visit) {
  for (std::size_t k = 0; k < found.crossings.size(); ++k) {
    const CrossingAt& c = found.crossings[k];
    visit(c.lines.s, c.at_s, first + static_cast<MeetingId>(k));
    visit(c.lines.o, c.at_o, first + static_cast<MeetingId>(k));
  }
  for (const Touch& t : found.touches) visit(t.line, t.at, t.end);
  for (const Through& t : found.throughs) visit(t.line, t.at, first + t.crossing);
}

/// The hits of each line, unsorted.
inline Grouped<Hit> collect_hits(std::size_t line_count, const std::vector<Meetings>& found,
                                 Job& job) {
  std::vector<MeetingId> first;
  for (const Meetings& block : found) {
    first.push_back(static_cast<MeetingId>(block.crossings.size()));
  }
  accumulate(first);
  if (first.back() + 2 * line_count > kMostItems) throw_too_many();
  for (MeetingId& m : first) m += static_cast<MeetingId>(2 * line_count);
  return group<Hit>(
      line_count, found.size(),
      [&](std::size_t begin, std::size_t end, const auto& visit) {
        for (std::size_t b = begin; b < end; ++b) {
          for_hits(found[b], first[b], [&](LineId s, double at, MeetingId m) {
            visit(s, Hit{at, m});
          });
        }
      },
      job);
}

/// Sorts the hits of a line and unites those at the same point.
template <class Kernel>
void sort_hits_of_line(LineId s, std::span<Hit> hits, double error,
                       const OrderOnLine<Kernel>& order, UnionFind& same) {
  if (hits.size() < 2) return;
  std::sort(hits.begin(), hits.end(), [&](const Hit& h, const Hit& k) {
    if (h.at + error < k.at) return true;
    if (k.at + error < h.at) return false;
    return order.compare(s, h.meeting, k.meeting) < 0;
  });
  for (std::size_t i = 1; i < hits.size(); ++i) {
    // Negated, so that a parameter that is no number is in doubt.
    if (!(hits[i].at > hits[i - 1].at + error) &&
        order.compare(s, hits[i - 1].meeting, hits[i].meeting) == 0) {
      same.unite(hits[i - 1].meeting, hits[i].meeting);
    }
  }
}

/// The meetings of each line in their order along it, and what vertices they are.
struct SortedHits {
  Grouped<Hit> hits;                  ///< per line
  std::vector<std::uint32_t> vertex;  ///< per meeting
  std::vector<MeetingId> least;       ///< per vertex the least of its meetings
};

/// Sorts the hits and numbers the vertices by their least meetings: ends in the order of their
/// lines, then crossings. `same_end`: per end the least of the ends at the same point.
template <class Kernel>
SortedHits sort_hits(const Scene<Kernel>& scene, const std::vector<EndId>& same_end,
                     const std::vector<Crossing>& crossings, Grouped<Hit> hits, Job& job) {
  const OrderOnLine<Kernel> order(scene.kernel, crossings);
  UnionFind same(same_end, same_end.size() + crossings.size());
  job.for_each(
      scene.kernel.size(),
      [&](std::size_t s) {
        const std::span<Hit> of_line =
            std::span<Hit>(hits.items).subspan(hits.begin[s], hits.begin[s + 1] - hits.begin[s]);
        sort_hits_of_line(static_cast<LineId>(s), of_line,
                          scene.parameter_error(static_cast<LineId>(s)), order, same);
      },
      kLinesPerTask);
  SortedHits sorted{std::move(hits), std::vector<std::uint32_t>(same.size()), {}};
  for (MeetingId m = 0; m < same.size(); ++m) {
    const MeetingId least = same.find(m);
    if (least == m) {
      sorted.vertex[m] = static_cast<std::uint32_t>(sorted.least.size());
      sorted.least.push_back(m);
    } else {
      sorted.vertex[m] = sorted.vertex[least];
    }
  }
  return sorted;
}

/// Calls visit(vertex) along a line.
template <class Visit>
void walk_line(LineId s, std::span<const Hit> hits, const std::vector<std::uint32_t>& number,
               Visit visit) {
  std::uint32_t before = number[first_end(s)];
  visit(before);
  for (const Hit& h : hits) {
    const std::uint32_t v = number[h.meeting];
    if (v != before) visit(v);
    before = v;
  }
  const std::uint32_t v = number[last_end(s)];
  if (v != before) visit(v);
}

inline Chains make_chains(const SortedHits& sorted, Job& job) {
  const std::size_t line_count = sorted.hits.size();
  Chains chains;
  chains.meeting = sorted.least;
  std::vector<std::uint32_t>& begin = chains.vertices.begin;
  begin.assign(line_count, 0);
  job.for_each(
      line_count,
      [&](std::size_t s) {
        const auto line = static_cast<LineId>(s);
        walk_line(line, sorted.hits[line], sorted.vertex, [&](std::uint32_t) { ++begin[s]; });
      },
      kLinesPerTask);
  accumulate(begin);
  chains.vertices.items.resize(begin.back());
  job.for_each(
      line_count,
      [&](std::size_t s) {
        const auto line = static_cast<LineId>(s);
        std::uint32_t* next = chains.vertices.items.data() + begin[s];
        walk_line(line, sorted.hits[line], sorted.vertex, [&](std::uint32_t v) { *next++ = v; });
      },
      kLinesPerTask);
  return chains;
}

}  // namespace plumbline::bucket

#pragma once

// Step 4: the meetings of each line, sorted along it; meetings at the same point become one vertex.

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "arrange/bucket/lines.hpp"
#include "arrange/bucket/meet.hpp"

namespace plumbline::bucket {

/// Sets of meetings at the same point, each represented by its least member.
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    if (i < j) {
      parent_[j] = i;
    } else {
      parent_[i] = j;
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// The chain of vertices of each line, from its first end to its last.
struct Chains {
  std::vector<std::uint32_t> begin;  ///< per line, into `vertex`
  std::vector<std::uint32_t> vertex;
  std::vector<MeetingId> meeting;  ///< of each vertex, one of its meetings
  std::span<const std::uint32_t> operator[](LineId line) const {
    return {vertex.data() + begin[line], begin[line + 1] - begin[line]};
  }
};

/// Decides about meetings on a line. Exact.
template <class Kernel>
class Along {
 public:
  Along(const Kernel& kernel, const Ends& ends, const std::vector<Crossing>& crossings)
      : kernel_(kernel), ends_(ends), crossings_(crossings) {}

  bool is_end(MeetingId m) const { return m < ends_.first.size(); }
  EndId end(MeetingId m) const { return ends_.first[m]; }
  const Crossing& crossing(MeetingId m) const { return crossings_[m - ends_.first.size()]; }
  /// A line that cuts s in meeting m, a crossing that s goes through.
  LineId cutter(LineId s, MeetingId m) const {
    const Crossing& c = crossing(m);
    if (c.s == s) return c.o;
    if (c.o == s) return c.s;
    return kernel_.compare_directions(s, c.s) != 0 ? c.s : c.o;
  }

  /// Order of two meetings along s.
  int compare(LineId s, MeetingId m, MeetingId n) const {
    if (m == n) return 0;
    if (is_end(m) && is_end(n)) return kernel_.compare(end(m), end(n));
    if (is_end(m)) return compare_end(s, m, n);
    if (is_end(n)) return -compare_end(s, n, m);
    return kernel_.compare_along(s, cutter(s, m), cutter(s, n));
  }

  /// Order of the x coordinates of a meeting on s and an end.
  int compare_x(LineId s, MeetingId m, EndId e) const {
    return is_end(m) ? kernel_.compare_x(end(m), e) : kernel_.compare_x(s, cutter(s, m), e);
  }

 private:
  /// An end on s comes before a crossing if it lies on the side of the cutting line where s begins.
  int compare_end(LineId s, MeetingId m, MeetingId n) const {
    const LineId o = cutter(s, n);
    const int of_end = kernel_.side(o, end(m));
    if (of_end == 0) return 0;
    return of_end == kernel_.side(o, first_end(s)) ? -1 : 1;
  }

  const Kernel& kernel_;
  const Ends& ends_;
  const std::vector<Crossing>& crossings_;
};

/// Hits of all lines, unsorted, as one array with a begin per line.
inline std::vector<std::uint32_t> collect_hits(std::size_t line_count, std::size_t end_count,
                                               const Meetings& found, std::vector<Hit>& hits) {
  std::vector<std::uint32_t> begin(line_count + 1, 0);
  for (const Crossing& c : found.crossings) {
    ++begin[c.s + 1];
    ++begin[c.o + 1];
  }
  for (const Touch& t : found.touches) ++begin[t.line + 1];
  for (const Through& t : found.throughs) ++begin[t.line + 1];
  for (std::size_t s = 0; s < line_count; ++s) begin[s + 1] += begin[s];
  hits.resize(begin.back());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t k = 0; k < found.crossings.size(); ++k) {
    const Crossing& c = found.crossings[k];
    const auto meeting = static_cast<MeetingId>(end_count + k);
    hits[next[c.s]++] = {c.at_s, meeting};
    hits[next[c.o]++] = {c.at_o, meeting};
  }
  for (const Touch& t : found.touches) hits[next[t.line]++] = {t.at, t.vertex};
  for (const Through& t : found.throughs) {
    hits[next[t.line]++] = {t.at, static_cast<MeetingId>(end_count + t.crossing)};
  }
  return begin;
}

/// Sorts the hits of each line and unites those at the same point.
template <class Kernel>
Chains make_chains(const Kernel& kernel, std::span<const Approx> approx, double extent,
                   const Ends& ends, const Meetings& found) {
  const std::size_t line_count = approx.size(), end_count = ends.first.size();
  std::vector<Hit> hits;
  const std::vector<std::uint32_t> begin = collect_hits(line_count, end_count, found, hits);
  const Along<Kernel> along(kernel, ends, found.crossings);
  UnionFind same(end_count + found.crossings.size());
  for (LineId s = 0; s < line_count; ++s) {
    // A parameter of a crossing is a ratio of two values with a relative error of kRelativeError
    // each, plus three roundings; one of an end suffers from the rounding of the coordinates.
    const double length =
        std::max(approx[s].bx - approx[s].ax, std::abs(approx[s].by - approx[s].ay));
    const double error = 8 * (Kernel::kRelativeError + 0x1p-53) + 16 * 0x1p-53 * (extent / length);
    const auto first = hits.begin() + begin[s], last = hits.begin() + begin[s + 1];
    std::sort(first, last, [&](const Hit& h, const Hit& k) {
      if (h.at + error < k.at) return true;
      if (k.at + error < h.at) return false;
      return along.compare(s, h.meeting, k.meeting) < 0;
    });
    for (auto h = first; h != last && h + 1 != last; ++h) {
      // Negated, so that a parameter that is no number is in doubt.
      if (!((h + 1)->at > h->at + error) && h->meeting != (h + 1)->meeting &&
          along.compare(s, h->meeting, (h + 1)->meeting) == 0) {
        same.unite(h->meeting, (h + 1)->meeting);
      }
    }
  }
  Chains chains;
  std::vector<std::uint32_t> number(end_count + found.crossings.size());
  for (MeetingId m = 0; m < number.size(); ++m) {
    const MeetingId least = same.find(m);
    if (least == m) {
      number[m] = static_cast<std::uint32_t>(chains.meeting.size());
      chains.meeting.push_back(m);
    } else {
      number[m] = number[least];
    }
  }
  chains.begin.reserve(line_count + 1);
  chains.vertex.reserve(hits.size() + 2 * line_count);
  for (LineId s = 0; s < line_count; ++s) {
    chains.begin.push_back(static_cast<std::uint32_t>(chains.vertex.size()));
    chains.vertex.push_back(number[ends.vertex[first_end(s)]]);
    for (std::uint32_t h = begin[s]; h < begin[s + 1]; ++h) {
      const std::uint32_t v = number[hits[h].meeting];
      if (v != chains.vertex.back()) chains.vertex.push_back(v);
    }
    const std::uint32_t v = number[ends.vertex[last_end(s)]];
    if (v != chains.vertex.back()) chains.vertex.push_back(v);
  }
  chains.begin.push_back(static_cast<std::uint32_t>(chains.vertex.size()));
  return chains;
}

}  // namespace plumbline::bucket

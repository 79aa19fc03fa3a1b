#pragma once

// Step 6: edges between successive vertices of each line, and around each vertex the halfedges in
// the order of the directions of their lines, which gives the next halfedge of each.

#include <algorithm>
#include <span>
#include <vector>

#include "arrange/bucket/chains.hpp"

namespace plumbline::bucket {

/// Edges are numbered along the lines, line after line; halfedge 2 e runs along its line.
struct Halfedges {
  std::vector<LineId> edge_line;
  Grouped<HalfedgeId>
      around;  ///< per vertex, leaving halfedges counter-clockwise from straight down
  std::vector<HalfedgeId> next;  ///< of the cycle on the left
};

/// The first edge of a line: a line of k vertices has k - 1 edges.
inline std::uint32_t first_edge(const Chains& chains, LineId s) {
  return chains.vertices.begin[s] - s;
}
/// The edge as a pair of vertices, in the direction of its line, hence lexicographic.
inline Edge edge_at(const Chains& chains, LineId line, EdgeId e) {
  const std::size_t i = static_cast<std::size_t>(e) + line;
  return {VertexId(chains.vertices.items[i]), VertexId(chains.vertices.items[i + 1])};
}

/// Fills `around`, unsorted save where two lines cross and nothing else happens: their order is
/// that of the crossing.
inline void collect_around(const Chains& chains, const std::vector<Crossing>& crossings,
                           Halfedges& h, Job& job) {
  const std::size_t line_count = chains.vertices.size();
  const MeetingId first_crossing = static_cast<MeetingId>(2 * line_count);
  std::vector<std::uint32_t>& begin = h.around.begin;
  begin.assign(chains.meeting.size(), 0);
  const auto add = [&](std::uint32_t& count, std::uint32_t v) {
    if (job.is_parallel()) {
      std::atomic_ref(count).fetch_add(v, std::memory_order_relaxed);
    } else {
      count += v;
    }
  };
  job.for_each(
      line_count,
      [&](std::size_t s) {
        const auto chain = chains[static_cast<LineId>(s)];
        if (chain.size() < 2) return;
        add(begin[chain.front()], 1);
        add(begin[chain.back()], 1);
        for (const std::uint32_t v : chain.subspan(1, chain.size() - 2)) add(begin[v], 2);
      },
      kLinesPerTask);
  accumulate(begin);
  h.around.items.resize(begin.back());
  std::vector<std::uint32_t> filled(chains.meeting.size(), 0);
  job.for_each(
      line_count,
      [&](std::size_t line) {
        const auto s = static_cast<LineId>(line);
        const auto chain = chains[s];
        const std::size_t first = first_edge(chains, s);
        for (std::size_t i = 0; i < chain.size() && chain.size() > 1; ++i) {
          const std::uint32_t v = chain[i];
          HalfedgeId* const slots = h.around.items.data() + begin[v];
          if (chains.meeting[v] >= first_crossing && begin[v + 1] - begin[v] == 4) {
            const std::size_t role = crossings[chains.meeting[v] - first_crossing].s == s ? 0 : 1;
            slots[role] = halfedge(EdgeId(first + i), false);
            slots[role + 2] = halfedge(EdgeId(first + i - 1), true);
            continue;
          }
          if (i + 1 < chain.size()) {
            slots[job.increment(filled[v])] = halfedge(EdgeId(first + i), false);
          }
          if (i > 0) slots[job.increment(filled[v])] = halfedge(EdgeId(first + i - 1), true);
        }
      },
      kLinesPerTask);
}

template <class Kernel>
Halfedges make_halfedges(const Kernel& kernel, const Chains& chains,
                         const std::vector<Crossing>& crossings, Job& job) {
  const std::size_t line_count = chains.vertices.size();
  const MeetingId first_crossing = static_cast<MeetingId>(2 * line_count);
  Halfedges h;
  h.edge_line.resize(chains.vertices.items.size() - line_count);
  job.for_each(
      line_count,
      [&](std::size_t s) {
        const auto line = static_cast<LineId>(s);
        std::fill_n(h.edge_line.begin() + first_edge(chains, line), chains[line].size() - 1, line);
      },
      kLinesPerTask);
  collect_around(chains, crossings, h, job);
  h.next.resize(2 * h.edge_line.size());
  job.for_each(chains.meeting.size(), [&](std::size_t v) {
    const std::uint32_t first = h.around.begin[v], last = h.around.begin[v + 1];
    HalfedgeId* const around = h.around.items.data();
    if (last - first > 1 && !(chains.meeting[v] >= first_crossing && last - first == 4)) {
      // Those along their lines leave to the right (or up), the others to the left; each half turns
      // as the lines do.
      std::sort(around + first, around + last, [&](HalfedgeId g, HalfedgeId k) {
        if (is_reversed(g) != is_reversed(k)) return !is_reversed(g);
        return kernel.compare_directions(h.edge_line[edge_of(g)], h.edge_line[edge_of(k)]) > 0;
      });
    }
    for (std::uint32_t k = first; k < last; ++k) {
      h.next[twin(around[k])] = around[k == first ? last - 1 : k - 1];
    }
  });
  return h;
}

}  // namespace plumbline::bucket

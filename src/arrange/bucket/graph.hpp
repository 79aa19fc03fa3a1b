#pragma once

// Step 5: edges between successive vertices of a line, equal ones merged; then the halfedges around
// each vertex in the order of the directions of their lines, and the cycles that this order makes.

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "arrange/bucket/vertices.hpp"

namespace plumbline::bucket {

struct Graph {
  std::vector<Edge> edges;        ///< tail first, as their lines run
  std::vector<LineId> edge_line;  ///< one line of each edge
  std::vector<std::uint32_t>
      line_edge;  ///< per line, the edges of its chain, as `chain_edge` + begin
  std::vector<std::uint32_t> chain_edge;
  /// Edges of several lines, with all of their lines; sorted by edge.
  std::vector<std::pair<std::uint32_t, LineId>> shared;
  std::vector<std::uint32_t> around_begin;  ///< per vertex, into `around`
  std::vector<HalfedgeId> around;  ///< leaving halfedges, counter-clockwise from straight down
};

/// Edges of all chains; those of overlapping lines that are equal become one.
inline Graph make_edges(const Chains& chains, std::size_t line_count,
                        const std::vector<LineId>& overlapping) {
  Graph g;
  std::vector<bool> overlaps(line_count, false);
  for (const LineId s : overlapping) overlaps[s] = true;
  struct Candidate {
    Edge edge;
    LineId line;
    std::uint32_t position;
  };
  std::vector<Candidate> candidates;
  g.edges.reserve(chains.vertex.size());
  g.edge_line.reserve(chains.vertex.size());
  for (LineId s = 0; s < line_count; ++s) {
    g.line_edge.push_back(static_cast<std::uint32_t>(g.chain_edge.size()));
    const auto chain = chains[s];
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const Edge edge{VertexId(chain[i]), VertexId(chain[i + 1])};
      if (overlaps[s]) {
        candidates.push_back({edge, s, static_cast<std::uint32_t>(g.chain_edge.size())});
        g.chain_edge.push_back(0);
      } else {
        g.chain_edge.push_back(static_cast<std::uint32_t>(g.edges.size()));
        g.edges.push_back(edge);
        g.edge_line.push_back(s);
      }
    }
  }
  g.line_edge.push_back(static_cast<std::uint32_t>(g.chain_edge.size()));
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    if (a.edge.tail != b.edge.tail) return a.edge.tail < b.edge.tail;
    return a.edge.head != b.edge.head ? a.edge.head < b.edge.head : a.line < b.line;
  });
  for (std::size_t i = 0; i < candidates.size();) {
    const auto edge = static_cast<std::uint32_t>(g.edges.size());
    g.edges.push_back(candidates[i].edge);
    g.edge_line.push_back(candidates[i].line);
    std::size_t j = i;
    for (; j < candidates.size() && candidates[j].edge == candidates[i].edge; ++j) {
      g.chain_edge[candidates[j].position] = edge;
    }
    for (std::size_t k = i; j - i > 1 && k < j; ++k)
      g.shared.emplace_back(edge, candidates[k].line);
    i = j;
  }
  return g;
}

template <class Kernel>
void order_around(Graph& g, const Kernel& kernel, std::size_t vertex_count) {
  g.around_begin.assign(vertex_count + 1, 0);
  for (const Edge& e : g.edges) {
    ++g.around_begin[e.tail + 1];
    ++g.around_begin[e.head + 1];
  }
  for (std::size_t v = 0; v < vertex_count; ++v) g.around_begin[v + 1] += g.around_begin[v];
  g.around.resize(2 * g.edges.size());
  std::vector<std::uint32_t> next(g.around_begin.begin(), g.around_begin.end() - 1);
  for (std::size_t e = 0; e < g.edges.size(); ++e) {
    g.around[next[g.edges[e].tail]++] = halfedge(EdgeId(e), false);
    g.around[next[g.edges[e].head]++] = halfedge(EdgeId(e), true);
  }
  for (std::size_t v = 0; v < vertex_count; ++v) {
    // Those along their lines leave to the right (or up), the others to the left; each half turns
    // as the lines do.
    std::sort(g.around.begin() + g.around_begin[v], g.around.begin() + g.around_begin[v + 1],
              [&](HalfedgeId h, HalfedgeId k) {
                if (is_reversed(h) != is_reversed(k)) return !is_reversed(h);
                return kernel.compare_directions(g.edge_line[edge_of(h)], g.edge_line[edge_of(k)]) >
                       0;
              });
  }
}

struct Cycles {
  Lists<HalfedgeId> list;
  std::vector<CycleId> of_halfedge;
};

inline Cycles walk_cycles(const Graph& g) {
  std::vector<HalfedgeId> next(2 * g.edges.size());
  for (std::size_t v = 0; v + 1 < g.around_begin.size(); ++v) {
    const std::uint32_t first = g.around_begin[v], last = g.around_begin[v + 1];
    for (std::uint32_t k = first; k < last; ++k) {
      next[twin(g.around[k])] = g.around[k == first ? last - 1 : k - 1];
    }
  }
  Cycles cycles;
  cycles.of_halfedge.resize(next.size());
  std::vector<HalfedgeId> cycle;
  for (std::size_t start = 0; start < next.size(); ++start) {
    if (cycles.of_halfedge[start].valid()) continue;
    cycle.clear();
    const CycleId id(cycles.list.size());
    for (HalfedgeId h(start); !cycles.of_halfedge[h].valid(); h = next[h]) {
      cycles.of_halfedge[h] = id;
      cycle.push_back(h);
    }
    cycles.list.push_back(cycle);
  }
  return cycles;
}

}  // namespace plumbline::bucket

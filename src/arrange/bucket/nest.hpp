#pragma once

// Step 6: connected components, and the face around each, found by a ray downwards from its least
// vertex.

#include <algorithm>
#include <optional>
#include <vector>

#include "arrange/bucket/buckets.hpp"
#include "arrange/bucket/graph.hpp"

namespace plumbline::bucket {

struct Component {
  EndId least;  ///< its lexicographically least vertex, always an end
  std::uint32_t vertex;
  CycleId hole;  ///< the cycle around it; none for an isolated vertex
};

/// The components, sorted by their least vertices.
template <class Kernel>
std::vector<Component> find_components(const Kernel& kernel, std::span<const Approx> approx,
                                       const Ends& ends, const Chains& chains, const Graph& g,
                                       const Cycles& cycles) {
  UnionFind sets(chains.meeting.size());
  for (const Edge& e : g.edges) {
    sets.unite(static_cast<std::uint32_t>(static_cast<std::size_t>(e.tail)),
               static_cast<std::uint32_t>(static_cast<std::size_t>(e.head)));
  }
  // A crossing is never the least vertex of its component, so only ends are looked at.
  constexpr EndId kNone = 0xffffffffU;
  std::vector<EndId> least(chains.meeting.size(), kNone);
  const auto x_of = [&](EndId e) {
    return is_last(e) ? approx[line_of(e)].bx : approx[line_of(e)].ax;
  };
  for (std::size_t v = 0; v < chains.meeting.size(); ++v) {
    if (chains.meeting[v] >= ends.first.size()) continue;
    const EndId e = ends.first[chains.meeting[v]];
    EndId& best = least[sets.find(static_cast<std::uint32_t>(v))];
    if (best == kNone || x_of(e) < x_of(best) ||
        (x_of(e) == x_of(best) && kernel.compare(e, best) < 0)) {
      best = e;
    }
  }
  std::vector<Component> components;
  for (const EndId e : least) {
    if (e == kNone) continue;
    // The chain's own vertex at this end.
    const auto chain = chains[line_of(e)];
    const std::uint32_t v = is_last(e) ? chain.back() : chain.front();
    const bool isolated = g.around_begin[v] == g.around_begin[v + 1];
    // Around the least vertex every halfedge leaves to the right; what is left of the last one of
    // them goes all around the component.
    const CycleId hole =
        isolated ? CycleId() : cycles.of_halfedge[g.around[g.around_begin[v + 1] - 1]];
    components.push_back({e, v, hole});
  }
  std::sort(components.begin(), components.end(), [&](const Component& a, const Component& b) {
    return kernel.compare(a.least, b.least) < 0;
  });
  return components;
}

template <class Kernel>
class Rays {
 public:
  Rays(const Kernel& kernel, std::span<const Approx> approx, const Buckets& buckets,
       const Chains& chains, const Graph& graph, const Along<Kernel>& along)
      : kernel_(kernel),
        approx_(approx),
        buckets_(buckets),
        chains_(chains),
        graph_(graph),
        along_(along) {}

  /// The halfedge just below an end, running rightwards, on a line just right of it.
  std::optional<HalfedgeId> below(EndId end) const {
    const Approx& l = approx_[line_of(end)];
    const double x = is_last(end) ? l.bx : l.ax, y = is_last(end) ? l.by : l.ay;
    std::optional<LineId> best;
    double height = 0;
    buckets_.down(x, y, [&](std::size_t bucket) {
      for (const LineId s : buckets_.lines(bucket)) {
        if (!passes_below(s, end, x)) continue;
        if (best && (s == *best || kernel_.compare_heights(s, *best, end) <= 0)) continue;
        best = s;
        height = height_at(s, x);
      }
      // What lies higher than the bottom of this bucket has been seen.
      return !best || height < buckets_.box(bucket).y0 + buckets_.margin();
    });
    if (!best) return std::nullopt;
    return halfedge(EdgeId(edge_at(*best, end)), false);
  }

 private:
  bool passes_below(LineId s, EndId end, double x) const {
    const Approx& l = approx_[s];
    if (x < l.ax || l.bx < x) return false;
    return kernel_.compare_x(first_end(s), end) <= 0 && kernel_.compare_x(end, last_end(s)) < 0 &&
           kernel_.side(s, end) > 0;
  }
  /// A lower bound of the height of s at x. Rounded coordinates are within the margin of the exact
  /// ones, so a steep line may be lower by that much times its slope.
  double height_at(LineId s, double x) const {
    const Approx& l = approx_[s];
    const auto [low, high] = std::minmax(l.ay, l.by);
    const double dx = l.bx - l.ax, uncertain = (high - low) * (buckets_.margin() / dx);
    if (!(uncertain < high - low)) return low;
    return std::max(low, l.ay + (l.by - l.ay) * ((x - l.ax) / dx) - uncertain);
  }
  /// The edge of s just right of an end's x.
  std::uint32_t edge_at(LineId s, EndId end) const {
    const auto chain = chains_[s];
    const auto right_of = std::partition_point(
        chain.begin() + 1, chain.end() - 1,
        [&](std::uint32_t v) { return along_.compare_x(s, chains_.meeting[v], end) <= 0; });
    return graph_
        .chain_edge[graph_.line_edge[s] + static_cast<std::uint32_t>(right_of - chain.begin()) - 1];
  }

  const Kernel& kernel_;
  std::span<const Approx> approx_;
  const Buckets& buckets_;
  const Chains& chains_;
  const Graph& graph_;
  const Along<Kernel>& along_;
};

}  // namespace plumbline::bucket

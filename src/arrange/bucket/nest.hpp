#pragma once

// Step 8: connected components, and a ray downwards from the least vertex of one to what is below.

#include <algorithm>
#include <vector>

#include "arrange/bucket/buckets.hpp"
#include "arrange/bucket/cycles.hpp"
#include "arrange/bucket/halfedges.hpp"

namespace plumbline::bucket {

struct Component {
  EndId least;  ///< an end at its lexicographically least vertex
  std::uint32_t vertex;
  CycleId hole;  ///< the cycle around it; none for an isolated vertex
  /// One that has the component, unless it is in a hole of that face, on its left, and that belongs
  /// to a component with a lesser vertex; none in the unbounded face.
  HalfedgeId before;
  /// Instead of that: the component of an isolated vertex, a lesser one, in the same face.
  std::uint32_t beside = kNone;
};

/// Connected components of the lines.
inline UnionFind connect_lines(const std::vector<Crossing>& crossings,
                               const std::vector<EndId>& same_end, const Grouped<Hit>& hits,
                               Job& job) {
  const std::size_t line_count = hits.size();
  UnionFind sets(line_count);
  job.for_each(
      line_count,
      [&](std::size_t s) {
        const auto line = static_cast<LineId>(s);
        for (const EndId e : {first_end(line), last_end(line)}) {
          if (line_of(same_end[e]) != line) sets.unite(line, line_of(same_end[e]));
        }
        for (std::uint32_t i = hits.begin[s]; i < hits.begin[s + 1]; ++i) {
          const MeetingId m = hits.items[i].meeting;
          const LineId other = m < 2 * line_count ? line_of(m) : crossings[m - 2 * line_count].s;
          if (other != line) sets.unite(line, other);
        }
      },
      kLinesPerTask);
  return sets;
}

/// The components without `before`, in the order of their first lines.
template <class Kernel>
std::vector<Component> find_components(const Kernel& kernel, const UnionFind& sets,
                                       const Chains& chains, const Halfedges& halfedges,
                                       const Cycles& cycles) {
  // The least vertex of a component is the first end of a line.
  std::vector<Component> components;
  std::vector<std::uint32_t> number(kernel.size());
  for (LineId s = 0; s < kernel.size(); ++s) {
    const LineId root = sets.find(s);
    if (root == s) {
      number[s] = static_cast<std::uint32_t>(components.size());
      components.push_back({first_end(s), 0, {}, {}, kNone});
    } else {
      EndId& least = components[number[root]].least;
      if (kernel.compare(first_end(s), least) < 0) least = first_end(s);
    }
  }
  for (Component& c : components) {
    c.vertex = chains[line_of(c.least)].front();
    const std::uint32_t first = halfedges.around.begin[c.vertex];
    const std::uint32_t last = halfedges.around.begin[c.vertex + 1];
    // Around the least vertex every halfedge leaves to the right; what is left of the last one of
    // them goes all around the component.
    if (first < last) c.hole = cycles.of_halfedge[halfedges.around.items[last - 1]];
  }
  return components;
}

template <class Kernel>
class Rays {
 public:
  Rays(const Kernel& kernel, std::span<const Approx> approx, const Buckets& buckets,
       const Chains& chains, const std::vector<Crossing>& crossings)
      : kernel_(kernel),
        approx_(approx),
        buckets_(buckets),
        chains_(chains),
        order_(kernel, crossings) {}

  /// The halfedge just below the first end of a line, running rightwards, on a line just right of
  /// it; none if there is nothing.
  HalfedgeId below(EndId end) const {
    const Approx& l = approx_[line_of(end)];
    const double x = l.ax, y = l.ay;
    LineId best = kNone;
    double height = 0;
    buckets_.down(x, y, [&](std::size_t bucket, double bottom) {
      for (const LineId s : buckets_.lines(bucket)) {
        if (s == best || !passes_below(s, end, x, y)) continue;
        if (best != kNone && kernel_.compare_heights(s, best, end) <= 0) continue;
        best = s;
        height = height_at(s, x);
      }
      // What lies higher than the bottom of this bucket has been seen.
      return best == kNone || height < bottom + buckets_.margin().border;
    });
    return best == kNone ? HalfedgeId() : halfedge(edge_right_of(best, end), false);
  }

 private:
  bool passes_below(LineId s, EndId end, double x, double y) const {
    const Approx& l = approx_[s];
    // Rounding to nearest keeps the order.
    if (x < l.ax || l.bx < x || y < std::min(l.ay, l.by)) return false;
    return kernel_.compare_x(first_end(s), end) <= 0 && kernel_.compare_x(end, last_end(s)) < 0 &&
           kernel_.side(s, end) > 0;
  }
  /// A lower bound of the height of s at x. Rounded coordinates are within the margin of the exact
  /// ones, so a steep line may be lower by that much times its slope.
  double height_at(LineId s, double x) const {
    const Approx& l = approx_[s];
    const auto [low, high] = std::minmax(l.ay, l.by);
    const double dx = l.bx - l.ax, uncertain = (high - low) * (buckets_.margin()(l) / dx);
    if (!(uncertain < high - low)) return low;
    return std::max(low, l.ay + (l.by - l.ay) * ((x - l.ax) / dx) - uncertain);
  }
  /// The edge of s just right of an end's x.
  EdgeId edge_right_of(LineId s, EndId end) const {
    const auto chain = chains_[s];
    const auto right = std::partition_point(
        chain.begin() + 1, chain.end() - 1,
        [&](std::uint32_t v) { return order_.compare_x(s, chains_.meeting[v], end) <= 0; });
    return EdgeId(first_edge(chains_, s) + static_cast<std::size_t>(right - chain.begin()) - 1);
  }

  const Kernel& kernel_;
  std::span<const Approx> approx_;
  const Buckets& buckets_;
  const Chains& chains_;
  const OrderOnLine<Kernel> order_;
};

}  // namespace plumbline::bucket

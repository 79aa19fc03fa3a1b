#pragma once

// Step 8, continued: what is just before each component. A short path leads from its least vertex
// back to an end nearby that is lexicographically before it. What the path meets first on its way
// from the component has the component on one side; everything on the path is before the vertex,
// so it belongs to a component with a lesser one. Where there is no such end, a ray downwards finds
// what is below.

#include <algorithm>
#include <optional>
#include <vector>

#include "arrange/bucket/nest.hpp"

namespace plumbline::bucket {

template <class Kernel>
class Paths {
 public:
  /// `kernel` without the paths; they are joined to it later.
  Paths(const Kernel& kernel, std::span<const Approx> approx, const Buckets& buckets,
        const Chains& chains, const Halfedges& halfedges, const std::vector<Crossing>& crossings)
      : kernel_(kernel),
        approx_(approx),
        buckets_(buckets),
        chains_(chains),
        halfedges_(halfedges),
        order_(kernel, crossings) {}

  /// An end before another one and near it: of a line in its bucket or next to its own along the
  /// curve. kNone if there is none.
  EndId target(EndId end) const {
    constexpr LineId kNeighbours = 8;
    const LineId line = line_of(end), count = static_cast<LineId>(approx_.size());
    Target nearest;
    for (const LineId s : some_lines(buckets_.bucket_at(approx_[line].ax, approx_[line].ay))) {
      look_at(s, end, nearest);
    }
    const LineId last = std::min(line + kNeighbours, count - 1);
    for (LineId s = line - std::min(line, kNeighbours); s <= last; ++s) look_at(s, end, nearest);
    return nearest.end;
  }

  /// What is on a path nearest to its last end, a halfedge that has that end on its left; none if
  /// that is the target, an isolated vertex; nothing if there is too much on the way. `path` is
  /// the line from `target` to the least vertex of a component.
  std::optional<HalfedgeId> before(LineId path, EndId target) const {
    constexpr std::size_t kMostLines = 4096;
    Place nearest{kNone, kNone};
    LineId line = kNone;
    std::size_t seen = 0;
    buckets_.for_near(kernel_.approx(path), [&](std::size_t bucket) {
      const auto lines = buckets_.lines(bucket);
      seen += 1 + lines.size();
      if (seen > kMostLines) return;
      for (const LineId s : lines) {
        const std::optional<Place> place = place_on(path, s);
        if (!place || (line != kNone && compare_places(kernel_, path, *place, nearest) <= 0)) {
          continue;
        }
        nearest = *place;
        line = s;
      }
    });
    if (seen > kMostLines) return {};
    if (line == kNone || nearest.end == first_end(path)) nearest.end = target;
    return nearest.end != kNone ? around(vertex_of(nearest.end), path) : across(line, path);
  }

 private:
  struct Target {
    EndId end = kNone;
    double distance = INFINITY;
  };
  void look_at(LineId s, EndId end, Target& nearest) const {
    const Approx &l = approx_[line_of(end)], &m = approx_[s];
    const auto look = [&](EndId e, double x, double y) {
      const double distance = std::max(std::abs(x - l.ax), std::abs(y - l.ay));
      if (distance < nearest.distance && kernel_.compare(e, end) < 0) nearest = {e, distance};
    };
    look(first_end(s), m.ax, m.ay);
    look(last_end(s), m.bx, m.by);
  }
  std::span<const LineId> some_lines(std::size_t bucket) const {
    constexpr std::size_t kSome = 64;
    const auto lines = buckets_.lines(bucket);
    return lines.first(std::min(lines.size(), kSome));
  }

  /// Where s meets the path, its last end left out, nearest to that.
  std::optional<Place> place_on(LineId path, LineId s) const {
    const Relation r = kernel_.relate(path, s);
    if (r.apart() || kernel_.is_point(s)) return {};
    if (r.cross()) return Place{kNone, s};
    if (r.b_to_s == 0 && is_on(path, last_end(s))) return Place{last_end(s), kNone};
    if (r.a_to_s == 0 && is_on(path, first_end(s))) return Place{first_end(s), kNone};
    if (r.a_to_o == 0 && kernel_.compare(first_end(s), first_end(path)) <= 0 &&
        kernel_.compare(first_end(path), last_end(s)) <= 0) {
      return Place{first_end(path), kNone};
    }
    return {};
  }
  /// Whether an end on the path's line is on the path, its last end left out.
  bool is_on(LineId path, EndId end) const {
    return kernel_.compare(first_end(path), end) <= 0 && kernel_.compare(end, last_end(path)) < 0;
  }

  std::uint32_t vertex_of(EndId end) const {
    const auto chain = chains_[line_of(end)];
    return is_last(end) ? chain.back() : chain.front();
  }

  /// Of a path that crosses a line: the halfedge there, or what is around the vertex there.
  HalfedgeId across(LineId s, LineId path) const {
    const auto chain = chains_[s];
    const Place crossing{kNone, path};
    const auto compare = [&](std::uint32_t v) {
      return order_.compare(s, chains_.meeting[v], crossing);
    };
    const auto at = std::partition_point(chain.begin() + 1, chain.end() - 1,
                                         [&](std::uint32_t v) { return compare(v) < 0; });
    if (at != chain.end() - 1 && compare(*at) == 0) return around(*at, path);
    const EdgeId edge(first_edge(chains_, s) + static_cast<std::size_t>(at - chain.begin()) - 1);
    return halfedge(edge, kernel_.side(s, last_end(path)) < 0);
  }

  /// The halfedge that leaves a vertex of the path next clockwise from the path.
  HalfedgeId around(std::uint32_t v, LineId path) const {
    const auto leaving = halfedges_.around[v];
    if (leaving.empty()) return {};
    const auto rightwards = std::partition_point(leaving.begin(), leaving.end(),
                                                 [](HalfedgeId h) { return !is_reversed(h); });
    const auto after = std::partition_point(leaving.begin(), rightwards, [&](HalfedgeId h) {
      return kernel_.compare_directions(halfedges_.edge_line[edge_of(h)], path) > 0;
    });
    return after == leaving.begin() ? leaving.back() : *(after - 1);
  }

  const Kernel& kernel_;
  std::span<const Approx> approx_;
  const Buckets& buckets_;
  const Chains& chains_;
  const Halfedges& halfedges_;
  const OrderOnLine<Kernel> order_;
};

/// Finds what is before each component.
template <class Kernel>
void look_before(Kernel& kernel, std::span<const Approx> approx, const Buckets& buckets,
                 const Chains& chains, const Halfedges& halfedges,
                 const std::vector<Crossing>& crossings, std::vector<Component>& components,
                 Job& job) {
  constexpr std::size_t kBlock = 256;
  const std::size_t line_count = kernel.size();
  std::vector<std::uint32_t> isolated(line_count, kNone);  // per line the component that it is
  for (std::size_t c = 0; c < components.size(); ++c) {
    if (!components[c].hole.valid()) {
      isolated[line_of(components[c].least)] = static_cast<std::uint32_t>(c);
    }
  }
  const Paths<Kernel> paths(kernel, approx, buckets, chains, halfedges, crossings);
  const Rays<Kernel> rays(kernel, approx, buckets, chains, crossings);
  std::vector<EndId> target(components.size());
  job.for_each(
      components.size(), [&](std::size_t c) { target[c] = paths.target(components[c].least); },
      kBlock);
  std::vector<LineId> path(components.size(), kNone);
  for (std::size_t c = 0; c < components.size(); ++c) {
    if (target[c] != kNone) path[c] = kernel.join(target[c], components[c].least);
  }
  job.for_each(
      components.size(),
      [&](std::size_t c) {
        std::optional<HalfedgeId> before;
        if (path[c] != kNone) before = paths.before(path[c], target[c]);
        components[c].before = before ? *before : rays.below(components[c].least);
        if (before && !before->valid()) components[c].beside = isolated[line_of(target[c])];
      },
      kBlock);
  kernel.resize(line_count);
}

}  // namespace plumbline::bucket

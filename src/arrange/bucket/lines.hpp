#pragma once

// Step 1: distinct lines in the order of a space-filling curve, and their distinct ends.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "arrange/bucket/types.hpp"

namespace plumbline::bucket {

/// Which input segments (and, after them, points) each line stands for.
struct Parents {
  std::vector<std::uint32_t> begin{0};
  std::vector<std::uint32_t> items;
  std::span<const std::uint32_t> operator[](LineId line) const {
    return {items.data() + begin[line], begin[line + 1] - begin[line]};
  }
};

/// Position along the Hilbert curve of a square of 2^16 x 2^16 cells.
std::uint32_t hilbert(std::uint32_t x, std::uint32_t y);

/// Sorts the kernel's lines along the curve and leaves out repetitions.
template <class Kernel>
Parents sort_lines(Kernel& kernel) {
  constexpr double kCells = 65535;
  const std::size_t n = kernel.size();
  std::vector<std::pair<std::uint32_t, LineId>> order(n);
  double x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
  for (std::size_t s = 0; s < n; ++s) {
    const Approx l = kernel.approx(static_cast<LineId>(s));
    x0 = std::min(x0, l.ax);
    x1 = std::max(x1, l.bx);
    y0 = std::min({y0, l.ay, l.by});
    y1 = std::max({y1, l.ay, l.by});
  }
  const double side = std::max({x1 - x0, y1 - y0, 1e-300});
  for (std::size_t s = 0; s < n; ++s) {
    const Approx l = kernel.approx(static_cast<LineId>(s));
    const auto cell = [&](double a, double b, double low) {
      return static_cast<std::uint32_t>(((a - low) / 2 + (b - low) / 2) / side * kCells);
    };
    order[s] = {hilbert(cell(l.ax, l.bx, x0), cell(l.ay, l.by, y0)), static_cast<LineId>(s)};
  }
  std::sort(order.begin(), order.end(), [&](const auto& p, const auto& q) {
    if (p.first != q.first) return p.first < q.first;
    if (kernel.less(p.second, q.second)) return true;
    return !kernel.less(q.second, p.second) && p.second < q.second;
  });
  Parents parents;
  std::vector<LineId> distinct;
  for (const auto& [key, s] : order) {
    if (distinct.empty() || !kernel.equal(distinct.back(), s)) {
      if (!distinct.empty())
        parents.begin.push_back(static_cast<std::uint32_t>(parents.items.size()));
      distinct.push_back(s);
    }
    parents.items.push_back(s);
  }
  if (!distinct.empty()) parents.begin.push_back(static_cast<std::uint32_t>(parents.items.size()));
  kernel.reorder(distinct);
  return parents;
}

/// The distinct end points.
struct Ends {
  std::vector<std::uint32_t> vertex;  ///< per end
  std::vector<EndId> first;           ///< per vertex, one of its ends
};

template <class Kernel>
Ends distinct_ends(const Kernel& kernel) {
  const std::size_t count = 2 * kernel.size();
  std::vector<EndId> order(count);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](EndId p, EndId q) {
    const int c = kernel.compare(p, q);
    return c != 0 ? c < 0 : p < q;
  });
  // Vertices are numbered by their first end along the curve, for the sake of locality.
  std::vector<EndId> representative(count);
  for (std::size_t i = 0; i < count; ++i) {
    const bool same = i > 0 && kernel.compare(order[i - 1], order[i]) == 0;
    representative[order[i]] = same ? representative[order[i - 1]] : order[i];
  }
  Ends ends;
  ends.vertex.resize(count);
  for (EndId e = 0; e < count; ++e) {
    if (representative[e] == e) {
      ends.vertex[e] = static_cast<std::uint32_t>(ends.first.size());
      ends.first.push_back(e);
    } else {
      ends.vertex[e] = ends.vertex[representative[e]];
    }
  }
  return ends;
}

}  // namespace plumbline::bucket

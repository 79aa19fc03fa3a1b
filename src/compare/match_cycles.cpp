// Walks the cycles of each side through the edge match.

#include <algorithm>

#include "compare/steps.hpp"

namespace plumbline::compare_steps {
namespace {

using Walk = std::vector<HalfedgeId>;

/// The halfedges that a cycle is on the other side; none if one of its edges is missing there.
Walk translated(const Sides& sides, Side side, const EdgeMatch& edges, CycleId cycle) {
  Walk result;
  for (const HalfedgeId h : sides[side].cycles[cycle]) {
    const auto image = edges.image(side, edge_of(h));
    if (!image) return {};
    if (!is_reversed(h)) {
      result.insert(result.end(), image->begin(), image->end());
    } else {
      std::transform(image->rbegin(), image->rend(), std::back_inserter(result), twin);
    }
  }
  return result;
}

bool equal_up_to_start(std::span<const HalfedgeId> cycle, const Walk& walk) {
  if (cycle.size() != walk.size()) return false;
  const auto start = std::find(cycle.begin(), cycle.end(), walk.front());
  const auto rest = static_cast<std::ptrdiff_t>(cycle.end() - start);
  return std::equal(start, cycle.end(), walk.begin()) &&
         std::equal(cycle.begin(), start, walk.begin() + rest);
}

std::vector<CycleId> cycles_of_halfedges(const ExactComplex& complex) {
  std::vector<CycleId> result(2 * complex.edge_count());
  for (std::size_t c = 0; c < complex.cycles.size(); ++c) {
    for (const HalfedgeId h : complex.cycles[c]) result[h] = CycleId(c);
  }
  return result;
}

}  // namespace

CycleMatch match_cycles(const Sides& sides, const EdgeMatch& edges) {
  CycleMatch result;
  for (const Side side : kBothSides) result.cycle_of[side] = cycles_of_halfedges(sides[side]);
  for (const Side side : kBothSides) {
    result.same[side].resize(sides[side].cycles.size());
    for (std::size_t c = 0; c < sides[side].cycles.size(); ++c) {
      const Walk walk = translated(sides, side, edges, CycleId(c));
      if (walk.empty()) continue;
      const CycleId candidate = result.cycle_of[other(side)][walk.front()];
      if (candidate.valid() && equal_up_to_start(sides[other(side)].cycles[candidate], walk)) {
        result.same[side][c] = candidate;
      }
    }
  }
  for (std::size_t c = 0; c < sides[Exact].cycles.size(); ++c) {
    const auto cycle = sides[Exact].cycles[c];
    const auto is_matched = [&](HalfedgeId h) { return edges.match[Exact][edge_of(h)].valid(); };
    result.is_one_to_one.push_back(result.same[Exact][c].valid() &&
                                   std::all_of(cycle.begin(), cycle.end(), is_matched));
  }
  return result;
}

}  // namespace plumbline::compare_steps

#include "arrange/bucket/cycles.hpp"

namespace plumbline::bucket {

Cycles walk_cycles(const std::vector<HalfedgeId>& next) {
  Cycles cycles;
  cycles.of_halfedge.resize(next.size());
  for (std::size_t start = 0; start < next.size(); ++start) {
    if (cycles.of_halfedge[start].valid()) continue;
    const CycleId id(cycles.first.size());
    cycles.first.emplace_back(start);
    for (HalfedgeId h(start); !cycles.of_halfedge[h].valid(); h = next[h]) {
      cycles.of_halfedge[h] = id;
    }
  }
  return cycles;
}

}  // namespace plumbline::bucket

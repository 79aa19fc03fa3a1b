// Step 4: the cycles are those that the sweep's rotations around the vertices make, in their order.

#include <string>

#include "steps.hpp"

namespace plumbline_checker {

Cycles check_cycles(const Certificate& certificate, const std::vector<Index>& next) {
  Cycles cycles;
  cycles.cycle_of.assign(next.size(), kNone);
  for (Index least = 0; least < next.size(); ++least) {
    if (cycles.cycle_of[least] != kNone) continue;
    const std::size_t cycle = cycles.halfedges.size();
    std::string right;
    for (Index h = least; cycles.cycle_of[h] == kNone; h = next[h]) {
      cycles.cycle_of[h] = static_cast<Index>(cycle);
      cycles.halfedges.values.push_back(h);
      right +=
          (h == least ? "" : " ") + std::string(h % 2 == 0 ? "+" : "-") + std::to_string(h / 2);
    }
    cycles.halfedges.close();
    if (cycle < certificate.cycles.size()) {
      require("cycle " + std::to_string(cycle), certificate.cycles[cycle], right,
              certificate.cycle_line + cycle);
    }
  }
  require("the number of cycles", std::to_string(certificate.cycles.size()),
          std::to_string(cycles.halfedges.size()), certificate.cycle_line - 1);
  return cycles;
}

}  // namespace plumbline_checker

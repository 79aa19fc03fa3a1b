#include "arrange/bucket/provenance.hpp"

namespace plumbline::bucket {

void Provenance::place(const Grouped<std::uint32_t>& chains) {
  std::vector<std::uint32_t> position;
  for (std::size_t c = 0; c < carriers.line.size(); ++c) {
    const auto chain = chains[carriers.line[c]];
    position.assign(1, 0);
    for (const LineId point : carriers.breaks[c]) {
      std::uint32_t i = position.back();
      while (chain[i] != chains[point].front()) ++i;
      position.push_back(i);
    }
    position.push_back(static_cast<std::uint32_t>(chain.size() - 1));
    std::uint32_t reach = 0;
    for (std::uint32_t p = carriers.parts.begin[c]; p < carriers.parts.begin[c + 1]; ++p) {
      Part& part = carriers.parts.items[p];
      part.from = position[part.from];
      part.to = position[part.to];
      reach = std::max(reach, part.to);
      part.reach = reach;
    }
  }
  carriers.breaks = {};
}

}  // namespace plumbline::bucket

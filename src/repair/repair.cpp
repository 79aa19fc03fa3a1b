#include "plumbline/repair.hpp"

#include <utility>

#include "plumbline/arrange.hpp"

namespace plumbline {

Repair repair(const SegmentSet& input, const RepairOptions& /*options*/) {
  Repair result;
  result.output = input;
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    result.origins.push_back(std::vector<SegmentId>{SegmentId(s)});
  }
  return result;
}

}  // namespace plumbline

#include <algorithm>

#include "plumbline/error.hpp"
#include "plumbline/geometry/layers.hpp"
#include "repair/steps.hpp"

namespace plumbline::repair_steps {

std::vector<SegmentId> anchored_segments(const SegmentSet& input, const RepairOptions& options) {
  std::vector<bool> is_anchored(input.sources.size());
  if (!options.anchors.empty()) is_anchored = sources_on_layers(input, options.anchors);
  for (const std::string& id : options.except) {
    bool found = false;
    for (std::size_t s = 0; s < input.sources.size(); ++s) {
      if (input.sources[s].id != id) continue;
      is_anchored[s] = found = true;
    }
    if (!found) {
      throw Error(ErrorCode::BadInput, "no element has this id",
                  {input.files.empty() ? "" : input.files.front(), 0, 0}, id);
    }
  }
  std::vector<SegmentId> result;
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    if (is_anchored[input.segment_source[s]]) result.emplace_back(s);
  }
  return result;
}

}  // namespace plumbline::repair_steps

#include <algorithm>
#include <string>

#include "edits/steps.hpp"

namespace plumbline::edits {
namespace {

bool is_strictly_ascending(std::span<const SegmentId> ids, std::size_t count) {
  return std::ranges::adjacent_find(ids, std::greater_equal()) == ids.end() &&
         (ids.empty() || ids.back() < count);
}

bool is_well_formed(const Line& line, std::size_t segments) {
  return line.a < line.b && is_strictly_ascending(line.segments, segments);
}

/// What the output has no reason to have otherwise than the input.
std::string kept_things(const SegmentSet& input, const SegmentSet& output) {
  if (output.files != input.files) return "files";
  if (output.points != input.points || output.point_source != input.point_source) return "points";
  if (output.labels != input.labels) return "labels";
  if (output.layers != input.layers) return "layers";
  if (output.unit != input.unit || output.crs != input.crs || output.y_up != input.y_up) {
    return "units";
  }
  const bool has_all =
      output.sources.size() >= input.sources.size() &&
      std::equal(input.sources.begin(), input.sources.end(), output.sources.begin());
  return has_all ? "" : "sources";
}

bool is_source_right(const SegmentSet& input, const Repair& repair, std::size_t i) {
  const SourceId source = repair.output.segment_source[i];
  if (source >= repair.output.sources.size()) return false;
  const auto origins = repair.origins[i];
  if (origins.empty()) return repair.output.sources[source].layer == kVirtualLayer;
  return std::ranges::any_of(origins,
                             [&](SegmentId s) { return input.segment_source[s] == source; });
}

std::vector<Breach> check_output(const SegmentSet& input, const Repair& repair) {
  std::vector<Breach> result;
  const std::size_t count = repair.output.segments.size();
  if (repair.origins.size() != count || repair.output.segment_source.size() != count) {
    result.push_back({"the output has " + std::to_string(count) + " segments, " +
                          std::to_string(repair.origins.size()) + " lists of origins and " +
                          std::to_string(repair.output.segment_source.size()) + " sources",
                      {},
                      {}});
    return result;
  }
  const std::string other = kept_things(input, repair.output);
  if (!other.empty()) {
    result.push_back({other + " of the output are not those of the input", {}, {}});
  }
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_ascending = is_strictly_ascending(repair.origins[i], input.segments.size());
    if (is_ascending && is_source_right(input, repair, i)) continue;
    const std::string what = is_ascending ? "a source that none of its origins has"
                                          : "origins that are not ascending ids of the input";
    result.push_back({"segment " + std::to_string(i) + " of the output has " + what,
                      repair.output.segments[i].a,
                      {}});
  }
  return result;
}

}  // namespace

std::vector<Breach> check_form(const SegmentSet& input, const Repair& repair) {
  std::vector<Breach> result = check_output(input, repair);
  const std::size_t count = input.segments.size();
  for (std::size_t t = 0; t < repair.edits.size(); ++t) {
    const Edit& edit = repair.edits[t];
    const auto is_right = [&](const Line& line) { return is_well_formed(line, count); };
    if (std::ranges::all_of(edit.before, is_right) && std::ranges::all_of(edit.after, is_right)) {
      continue;
    }
    result.push_back(
        {to_text(edit.kind) + " has a line whose ends or segments are in no order", edit.where, t});
  }
  for (const Refusal& refusal : repair.refused) {
    if (is_strictly_ascending(refusal.segments, count)) continue;
    result.push_back({"a refused " + to_text(refusal.kind) +
                          " names segments that are not ascending ids of the input",
                      refusal.where,
                      {}});
  }
  if (!is_strictly_ascending(repair.anchored, count)) {
    result.push_back({"anchored segments are not ascending ids of the input", {}, {}});
  }
  return result;
}

}  // namespace plumbline::edits

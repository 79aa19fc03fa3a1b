// What regions a drawing has.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "plumbline/regions.hpp"

namespace plumbline {
namespace {

bool is_closed(const SegmentSet& input, const Ring& ring) {
  if (ring.count == 0) return false;
  const auto first = input.segments.numbers(ring.first);
  const auto last = input.segments.numbers(ring.first + ring.count - 1);
  return first[0] == last[2] && first[1] == last[3];
}

std::vector<Region> polygon_regions(const SegmentSet& input, FillRule rule) {
  std::vector<Region> result;
  bool is_whole = false;  // whether all rings of the last region are closed
  const auto end = [&] {
    if (!result.empty() && !is_whole) result.pop_back();
  };
  for (const Ring& ring : input.rings) {
    if (ring.role == RingRole::Polygon || ring.role == RingRole::Line) {
      end();
      const bool has_segments = ring.count > 0;
      result.push_back(
          {has_segments ? input.sources[input.segment_source[ring.first]].layer : "", rule, {}});
      is_whole = true;
    }
    // A ring without length encloses nothing, and takes nothing from the others.
    if (ring.count == 0) continue;
    is_whole = is_whole && is_closed(input, ring);
    for (std::size_t s = ring.first; s < ring.first + ring.count; ++s) {
      result.back().segments.emplace_back(s);
    }
  }
  end();
  return result;
}

std::vector<Region> whole_layers(const SegmentSet& input, FillRule rule) {
  std::map<std::string, std::vector<SegmentId>> of_layers;
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    of_layers[input.sources[input.segment_source[s]].layer].emplace_back(s);
  }
  std::vector<Region> result;
  for (auto& [layer, segments] : of_layers) {
    result.push_back({layer, rule, std::move(segments)});
  }
  return result;
}

}  // namespace

std::vector<Region> regions(const SegmentSet& input, RegionKind kind, FillRule rule) {
  return kind == RegionKind::Polygon ? polygon_regions(input, rule) : whole_layers(input, rule);
}

std::string source_text(const Region& region, const SegmentSet& input) {
  if (region.segments.empty()) return "?";
  return to_text(input.sources[input.segment_source[region.segments.front()]], input.files);
}

}  // namespace plumbline

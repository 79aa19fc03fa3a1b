// What the layers of a drawing enclose: polygons, and lines that close.

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/union_find.hpp"
#include "plumbline/regions.hpp"

namespace plumbline {
namespace {

/// An end of a segment. The texts of equal numbers are equal.
struct End {
  const std::string* layer;
  NumberPoint at;
  SegmentId segment;

  auto place() const { return std::tie(*layer, at.x, at.y); }
};

std::vector<End> ends_of(const SegmentSet& input, const std::vector<std::string>& layers,
                         const std::vector<SegmentId>& segments) {
  std::vector<End> ends;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto n = input.segments.numbers(segments[i]);
    ends.push_back({&layers[i], {n[0], n[1]}, SegmentId(i)});
    ends.push_back({&layers[i], {n[2], n[3]}, SegmentId(i)});
  }
  std::sort(ends.begin(), ends.end(),
            [](const End& a, const End& b) { return a.place() < b.place(); });
  return ends;
}

/// Per segment whether it hangs together by ends with others, an even number at each.
std::vector<bool> are_closed(const std::vector<End>& ends, std::size_t count) {
  UnionFind together(count);
  std::vector<std::size_t> odd;
  for (std::size_t i = 0; i < ends.size();) {
    const std::size_t first = i;
    for (++i; i < ends.size() && ends[i].place() == ends[first].place(); ++i) {
      together.unite(ends[first].segment, ends[i].segment);
    }
    if ((i - first) % 2 != 0) odd.push_back(ends[first].segment);
  }
  std::vector<bool> is_open(count), result(count);
  for (const std::size_t s : odd) is_open[together.find(s)] = true;
  for (std::size_t s = 0; s < count; ++s) result[s] = !is_open[together.find(s)];
  return result;
}

}  // namespace

LayerRegions layer_regions(const SegmentSet& input, FillRule rule) {
  LayerRegions result{regions(input, RegionKind::Polygon, rule), {}};
  std::vector<bool> is_taken(input.segments.size());
  for (const Region& region : result.regions) {
    for (const SegmentId s : region.segments) is_taken[s] = true;
  }
  std::vector<SegmentId> rest;
  std::vector<std::string> layers;
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    if (is_taken[s]) continue;
    rest.emplace_back(s);
    layers.push_back(input.sources[input.segment_source[s]].layer);
  }
  const std::vector<bool> is_closed = are_closed(ends_of(input, layers, rest), rest.size());
  std::map<std::string, std::vector<SegmentId>> of_layers;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    (is_closed[i] ? of_layers[layers[i]] : result.open).push_back(rest[i]);
  }
  for (auto& [layer, segments] : of_layers) {
    result.regions.push_back({layer, FillRule::EvenOdd, std::move(segments)});
  }
  return result;
}

}  // namespace plumbline

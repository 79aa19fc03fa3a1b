// Polygons that are joined to what they cover together, and regions as drawings.

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plumbline/arrange.hpp"
#include "plumbline/dissolve.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

/// Some regions of a drawing, with no segments but theirs.
struct Part {
  SegmentSet input;
  std::vector<SegmentId> origin;  ///< per segment, that of the whole drawing
  std::vector<Region> regions;

  void add(const SegmentSet& whole, const Region& region) {
    Region& own = regions.emplace_back(Region{region.name, region.rule, {}});
    for (const SegmentId s : region.segments) {
      const auto n = whole.segments.numbers(s);
      own.segments.emplace_back(origin.size());
      input.segments.push_back({n[0], n[1]}, {n[2], n[3]});
      input.segment_source.emplace_back(0);
      origin.push_back(s);
    }
  }
};

RegionPolygons covered(const Part& part, std::size_t threads) {
  ArrangeOptions options;
  options.threads = threads;
  const ExactComplex complex = arrange(part.input, ExactEngine::Bucket, options);
  const FaceSet faces = select(label(part.input, complex, part.regions),
                               [](const Membership& m) { return m.count() > 0; });
  RegionPolygons result = region_polygons(complex, faces);
  Lists<SegmentId> sources;
  std::vector<SegmentId> of_edge;
  for (std::size_t e = 0; e < result.complex.edge_count(); ++e) {
    of_edge.clear();
    for (const SegmentId s : result.complex.edge_sources[e]) of_edge.push_back(part.origin[s]);
    std::sort(of_edge.begin(), of_edge.end());
    sources.push_back(of_edge);
  }
  result.complex.edge_sources = std::move(sources);
  return result;
}

}  // namespace

std::vector<RegionPolygons> dissolve(const SegmentSet& input, const std::vector<Region>& regions,
                                     std::span<const std::uint32_t> groups, std::size_t threads) {
  ensure(groups.size() == regions.size(), "each region has a group");
  std::vector<Part> parts(groups.empty() ? 0
                                         : 1U + *std::max_element(groups.begin(), groups.end()));
  for (Part& part : parts) part.input.add_source({});
  for (std::size_t r = 0; r < regions.size(); ++r) parts[groups[r]].add(input, regions[r]);
  std::vector<RegionPolygons> result;
  for (const Part& part : parts) result.push_back(covered(part, threads));
  return result;
}

SegmentSet drawing_of(const RegionPolygons& regions) {
  SegmentSet result;
  const std::uint32_t file = result.add_file("<regions>");
  const auto add = [&](auto ring, RingRole role, SourceId source) {
    result.rings.push_back({static_cast<std::uint32_t>(result.segments.size()),
                            static_cast<std::uint32_t>(ring.size()), role});
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const VertexId a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      result.add(Segment{regions.complex.vertices[a], regions.complex.vertices[b]}, source);
    }
  };
  for (std::size_t p = 0; p < regions.polygons.size(); ++p) {
    Source source;
    source.file = file;
    source.element = "Polygon";
    source.id = std::to_string(p + 1);
    const SourceId id = result.add_source(source);
    const FacePolygon& polygon = regions.polygons[p];
    add(std::span(polygon.outer), RingRole::Polygon, id);
    for (std::size_t h = 0; h < polygon.holes.size(); ++h) {
      add(polygon.holes[h], RingRole::Hole, id);
    }
  }
  return result;
}

}  // namespace plumbline

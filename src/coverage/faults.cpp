// What is wrong with a coverage.

#include <algorithm>
#include <tuple>
#include <utility>

#include "coverage/steps.hpp"

namespace plumbline {
namespace {

using coverage_steps::Corners;

/// The polygons on the other sides of a face, ascending.
std::vector<RegionId> around(const Coverage& coverage, FaceId face, std::span<const EdgeId> edges) {
  std::vector<RegionId> result;
  for (const EdgeId e : edges) {
    const auto owners = coverage.owners[coverage_steps::across(coverage.complex, e, face)];
    result.insert(result.end(), owners.begin(), owners.end());
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Overlaps and gaps.
std::vector<CoverageFault> faces_at_fault(const Coverage& coverage) {
  const std::vector<Rational> areas = face_areas(coverage.complex);
  const Lists<EdgeId> edges = coverage_steps::edges_of_faces(coverage.complex);
  std::vector<CoverageFault> result;
  for (std::size_t f = 1; f < areas.size(); ++f) {
    const auto owners = coverage.owners[f];
    if (owners.size() == 1) continue;
    CoverageFault fault;
    fault.face = FaceId(f);
    fault.kind = owners.empty() ? CoverageFaultKind::Gap : CoverageFaultKind::Overlap;
    fault.polygons.assign(owners.begin(), owners.end());
    if (owners.empty()) fault.polygons = around(coverage, fault.face, edges[f]);
    fault.at = interior_point(coverage.complex, fault.face);
    fault.area = areas[f];
    fault.width = coverage_steps::width(coverage.complex, fault.face, edges[f], areas[f]);
    result.push_back(std::move(fault));
  }
  return result;
}

/// A polygon at a vertex: on a side, or with a corner.
struct Visit {
  VertexId vertex;
  RegionId polygon;
  bool is_corner = false;

  friend auto operator<=>(const Visit&, const Visit&) = default;
};

/// Ascending, of a vertex and a polygon first what is no corner.
std::vector<Visit> visits_of(const Coverage& coverage, const SegmentSet& input) {
  const ExactComplex& complex = coverage.complex;
  const Corners corners(input, coverage.polygons);
  std::vector<Point> places;
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) places.push_back(complex.vertices[v]);
  std::vector<Visit> result;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    for (const VertexId v : {complex.edges[e].tail, complex.edges[e].head}) {
      for (const SegmentId s : complex.edge_sources[e]) {
        const RegionId polygon = corners.polygon_of(s);
        if (polygon.valid()) result.push_back({v, polygon, corners.ends_at(s, places[v])});
      }
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void add_vertices_at_fault(const Coverage& coverage, std::span<const Visit> visits,
                           std::vector<CoverageFault>& result) {
  for (std::size_t i = 0, end = 0; i < visits.size(); i = end) {
    std::vector<RegionId> with, without;
    for (; end < visits.size() && visits[end].vertex == visits[i].vertex; ++end) {
      const auto& [vertex, polygon, is_corner] = visits[end];
      if (is_corner && !without.empty() && without.back() == polygon) without.pop_back();
      (is_corner ? with : without).push_back(polygon);
    }
    if (with.empty()) continue;
    for (const RegionId polygon : without) {
      CoverageFault fault;
      fault.kind = CoverageFaultKind::UnmatchedVertex;
      fault.polygons = {polygon};
      fault.polygons.insert(fault.polygons.end(), with.begin(), with.end());
      fault.at = coverage.complex.vertices[visits[i].vertex];
      result.push_back(std::move(fault));
    }
  }
}

}  // namespace

std::string to_text(CoverageFaultKind kind) {
  switch (kind) {
    case CoverageFaultKind::Overlap:
      return "overlap";
    case CoverageFaultKind::Gap:
      return "gap";
    case CoverageFaultKind::UnmatchedVertex:
      break;
  }
  return "unmatched vertex";
}

bool is_within(const CoverageFault& fault, const CleanOptions& options) {
  if (fault.kind == CoverageFaultKind::UnmatchedVertex) return true;
  const SizeLimit& limit = fault.kind == CoverageFaultKind::Gap ? options.gaps : options.overlaps;
  return (!limit.width || fault.width <= nearest_double(*limit.width)) &&
         (!limit.area || fault.area <= *limit.area);
}

std::vector<CoverageFault> faults(const Coverage& coverage, const SegmentSet& input) {
  std::vector<CoverageFault> result = faces_at_fault(coverage);
  add_vertices_at_fault(coverage, visits_of(coverage, input), result);
  return result;
}

}  // namespace plumbline

// Which polygons lie where, and what they are made of.

#include "plumbline/coverage.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "coverage/steps.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

/// Readers have polygons of one kind and layer together.
void sort_as_in_file(std::vector<Region>& polygons, const SegmentSet& input) {
  using Place = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
  std::vector<std::pair<Place, std::size_t>> order;
  for (std::size_t r = 0; r < polygons.size(); ++r) {
    if (polygons[r].segments.empty()) continue;
    const Source source = input.sources[input.segment_source[polygons[r].segments.front()]];
    order.emplace_back(Place(source.file, source.line, source.column), r);
  }
  std::sort(order.begin(), order.end());
  std::vector<Region> sorted;
  for (const auto& [place, r] : order) sorted.push_back(std::move(polygons[r]));
  polygons = std::move(sorted);
}

}  // namespace

namespace coverage_steps {

Coverage by_owners(const ExactComplex& complex, const Lists<RegionId>& owners,
                   std::vector<Region> polygons) {
  std::map<std::vector<RegionId>, std::uint32_t> numbers{{{}, 0}};
  std::vector<std::uint32_t> classes;
  for (std::size_t f = 0; f < owners.size(); ++f) {
    const std::vector<RegionId> set(owners[f].begin(), owners[f].end());
    const auto number = static_cast<std::uint32_t>(numbers.size());
    classes.push_back(numbers.try_emplace(set, number).first->second);
  }
  JoinedComplex made = joined(complex, classes);
  std::vector<FaceId> origin(made.complex.face_count());
  for (std::size_t f = 0; f < classes.size(); ++f) origin[made.face_of[f]] = FaceId(f);
  Coverage result{std::move(polygons), std::move(made.complex), {}};
  for (const FaceId f : origin) result.owners.push_back(owners[f]);
  return result;
}

Lists<EdgeId> edges_of_faces(const Incidences& complex) {
  std::vector<std::vector<EdgeId>> edges(complex.face_count());
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    for (const bool reversed : {false, true}) {
      edges[complex.halfedge_face[halfedge(EdgeId(e), reversed)]].emplace_back(e);
    }
  }
  Lists<EdgeId> result;
  for (const auto& of : edges) result.push_back(of);
  return result;
}

FaceId across(const Incidences& complex, EdgeId e, FaceId face) {
  const FaceId left = complex.halfedge_face[halfedge(e, false)];
  return left == face ? complex.halfedge_face[halfedge(e, true)] : left;
}

Corners::Corners(const SegmentSet& input, const std::vector<Region>& polygons)
    : input_(input), polygon_of_(input.segments.size()) {
  for (std::size_t r = 0; r < polygons.size(); ++r) {
    for (const SegmentId s : polygons[r].segments) polygon_of_[s] = RegionId(r);
  }
}

bool Corners::ends_at(SegmentId s, const Point& p) const {
  const Segment segment = input_.segments[s];
  return segment.a == p || segment.b == p;
}

}  // namespace coverage_steps

Coverage coverage(const SegmentSet& input, const ExactComplex& complex, FillRule rule) {
  std::vector<Region> polygons = regions(input, RegionKind::Polygon, rule);
  sort_as_in_file(polygons, input);
  LabelledComplex labelled = label(input, complex, std::move(polygons));
  const Lists<RegionId> owners = regions_of_faces(labelled);
  return coverage_steps::by_owners(complex, owners, std::move(labelled.regions));
}

std::vector<Rational> polygon_areas(const Coverage& coverage) {
  const std::vector<Rational> areas = face_areas(coverage.complex);
  std::vector<Rational> result(coverage.polygons.size());
  for (std::size_t f = 0; f < areas.size(); ++f) {
    for (const RegionId r : coverage.owners[f]) result[r] += areas[f];
  }
  return result;
}

}  // namespace plumbline

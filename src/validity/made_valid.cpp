// Valid polygons in place of one that is not.

#include <algorithm>
#include <span>
#include <utility>

#include "plumbline/arrange.hpp"
#include "plumbline/error.hpp"
#include "plumbline/validity.hpp"

namespace plumbline {
namespace {

/// The rings of one polygon, closed.
struct Rings {
  SegmentSet drawing;
  std::vector<Region> regions;  ///< one for each ring
  std::vector<std::size_t> parts;
  std::vector<bool> are_holes;
};

void add_ring(Rings& rings, const SegmentSet& input, const Ring& ring) {
  if (ring.count == 0) return;
  Region& region = rings.regions.emplace_back();
  region.rule = FillRule::NonZero;
  SegmentList& segments = rings.drawing.segments;
  const auto add = [&](NumberPoint a, NumberPoint b) {
    region.segments.emplace_back(segments.size());
    segments.push_back(std::move(a), std::move(b));
    rings.drawing.segment_source.emplace_back(0);
  };
  for (std::size_t s = ring.first; s < ring.first + ring.count; ++s) {
    const auto n = input.segments.numbers(s);
    add({n[0], n[1]}, {n[2], n[3]});
  }
  const auto first = input.segments.numbers(ring.first);
  const auto last = input.segments.numbers(ring.first + ring.count - 1);
  const NumberPoint begin{first[0], first[1]}, end{last[2], last[3]};
  if (begin != end) add(end, begin);
}

Rings rings_of(const SegmentSet& input, const PolygonValidity& polygon) {
  Rings result;
  result.drawing.add_source({});
  std::size_t part = 0;
  for (std::size_t r = polygon.first_ring; r <= polygon.last_ring; ++r) {
    const bool is_hole = input.rings[r].role == RingRole::Hole;
    if (!is_hole) ++part;
    add_ring(result, input, input.rings[r]);
    result.parts.resize(result.regions.size(), part);
    result.are_holes.resize(result.regions.size(), is_hole);
  }
  return result;
}

/// All rings as one region.
std::vector<Region> together(const std::vector<Region>& rings, FillRule rule) {
  Region all{"", rule, {}};
  for (const Region& ring : rings) {
    all.segments.insert(all.segments.end(), ring.segments.begin(), ring.segments.end());
  }
  return {std::move(all)};
}

/// Whether what lies in these rings lies in a part and in none of its holes.
bool is_in_part(const Rings& rings, std::span<const RegionId> around) {
  return std::ranges::any_of(around, [&](RegionId outer) {
    return !rings.are_holes[outer] && std::ranges::none_of(around, [&](RegionId hole) {
      return rings.are_holes[hole] && rings.parts[hole] == rings.parts[outer];
    });
  });
}

}  // namespace

ValidMeaning valid_meaning(std::string_view word) {
  const auto found = std::find(std::begin(kValidMeanings), std::end(kValidMeanings), word);
  if (found == std::end(kValidMeanings)) {
    throw Error(ErrorCode::BadInput, "valid polygons are made by linework, structure or nonzero",
                {}, std::string(word));
  }
  return static_cast<ValidMeaning>(found - std::begin(kValidMeanings));
}

RegionPolygons made_valid(const SegmentSet& input, const PolygonValidity& polygon,
                          ValidMeaning meaning) {
  const Rings rings = rings_of(input, polygon);
  ArrangeOptions options;
  options.threads = 1;
  const ExactComplex complex = arrange(rings.drawing, ExactEngine::Bucket, options);
  FaceSet faces(complex.face_count());
  if (meaning == ValidMeaning::Structure) {
    const Lists<RegionId> around = regions_of_faces(label(rings.drawing, complex, rings.regions));
    for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = is_in_part(rings, around[f]);
  } else {
    const FillRule rule = meaning == ValidMeaning::Linework ? FillRule::EvenOdd : FillRule::NonZero;
    faces = select(label(rings.drawing, complex, together(rings.regions, rule)),
                   [](const Membership& m) { return m.count() > 0; });
  }
  return region_polygons(complex, faces);
}

}  // namespace plumbline

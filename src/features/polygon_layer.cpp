// Polygons as they are now, each with the element that it was drawn as.

#include <algorithm>
#include <utility>

#include "features/parts.hpp"
#include "plumbline/features.hpp"

namespace plumbline {
namespace {

/// The sides in doubles, lesser ends first, ascending.
using Sides = std::vector<std::pair<PointD, PointD>>;

void add_side(Sides& sides, const PointD& a, const PointD& b) {
  if (a != b) sides.push_back(std::minmax(a, b));
}

Sides sides_of(const Region& polygon, const SegmentSet& input) {
  Sides result;
  for (const SegmentId s : polygon.segments) {
    const auto n = input.segments.numbers(s);
    add_side(result, nearest(NumberPoint{n[0], n[1]}), nearest(NumberPoint{n[2], n[3]}));
  }
  std::sort(result.begin(), result.end());
  return result;
}

Sides sides_of(const PolygonParts& parts) {
  Sides result;
  for (const auto& part : parts) {
    for (const auto& ring : part) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        add_side(result, ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]);
      }
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Whether the drawing has the very decimals that are written for its points: else what is written
/// of a neighbour would be a hair off.
bool is_written_so(const Region& polygon, const SegmentSet& input) {
  const auto is_same = [](const Number& number, double rounded) {
    return number == parse_number(shortest_text(rounded));
  };
  return std::ranges::all_of(polygon.segments, [&](SegmentId s) {
    const auto n = input.segments.numbers(s);
    const PointD p = nearest(NumberPoint{n[0], n[1]});
    return is_same(n[0], p.x) && is_same(n[1], p.y);
  });
}

Source source_of(const Region& polygon, const SegmentSet& input) {
  if (polygon.segments.empty()) return {};
  return input.sources[input.segment_source[polygon.segments.front()]];
}

}  // namespace

std::vector<DrawnPolygon> drawn_polygons(const Coverage& coverage, const SegmentSet& input,
                                         const Rounding& rounding) {
  Lists<RegionId> owners;
  for (const FaceId f : rounding.face_origin) owners.push_back(coverage.owners[f]);
  const std::vector<Rational> areas = polygon_areas(coverage);
  const auto owned = owned_polygons(rounding.complex, owners, coverage.polygons.size());
  std::vector<DrawnPolygon> result;
  for (std::size_t r = 0; r < owned.size(); ++r) {
    const Region& polygon = coverage.polygons[r];
    DrawnPolygon& drawn = result.emplace_back();
    drawn.source = source_of(polygon, input);
    drawn.area = areas[r];
    for (const FacePolygon& part : owned[r]) {
      drawn.parts.push_back(features::parts(rounding.complex, part));
    }
    drawn.is_as_drawn =
        sides_of(drawn.parts) == sides_of(polygon, input) && is_written_so(polygon, input);
  }
  return result;
}

PolygonParts polygon_parts(const RegionPolygons& made) {
  ArrangeOptions options;
  options.threads = 1;
  const Rounding rounding = safely_rounded(made.complex, {}, options);
  std::vector<bool> is_part(made.complex.face_count());
  for (const FacePolygon& polygon : made.polygons) is_part[polygon.face] = true;
  PolygonParts result;
  for (const FacePolygon& polygon : polygons(rounding.complex)) {
    if (!is_part[rounding.face_origin.at(polygon.face)]) continue;
    result.push_back(features::parts(rounding.complex, polygon));
  }
  return result;
}

FeatureLayer polygon_layer(const std::vector<DrawnPolygon>& polygons,
                           const std::vector<std::string>& files) {
  FeatureLayer layer{"polygons",
                     FeatureGeometry::Polygon,
                     {"polygon", "id", "layer", "source", "area", "area_exact"},
                     {}};
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    const auto& [source, parts, is_as_drawn, area] = polygons[p];
    for (const auto& part : parts) {
      Feature& feature = layer.features.emplace_back();
      feature.parts = part;
      feature.layer = source.layer;
      feature.values = {
          features::number(p + 1), source.id,       source.layer, to_text(source, files),
          nearest_double(area),    exact_text(area)};
    }
  }
  return layer;
}

}  // namespace plumbline

// Selected regions as polygons.

#include <utility>
#include <vector>

#include "features/parts.hpp"
#include "plumbline/features.hpp"

namespace plumbline {

FeatureLayer region_layer(const RegionPolygons& regions, const Rounding& rounding) {
  using features::number;
  FeatureLayer layer{"regions", FeatureGeometry::Polygon, {"polygon", "area", "area_exact"}, {}};
  std::vector<std::size_t> number_of(regions.complex.face_count());  // from 1
  for (std::size_t p = 0; p < regions.polygons.size(); ++p) {
    number_of[regions.polygons[p].face] = p + 1;
  }
  const bool is_same = rounding.has_same_incidences();
  const std::vector<Rational> areas =
      is_same ? std::vector<Rational>() : face_areas(rounding.complex);
  for (const FacePolygon& polygon : polygons(rounding.complex)) {
    const std::size_t n = number_of[rounding.face_origin.at(polygon.face)];
    if (n == 0) continue;
    const Rational& area = is_same ? regions.areas[n - 1] : areas[polygon.face];
    layer.features.push_back({features::parts(rounding.complex, polygon),
                              {number(n), nearest_double(area), exact_text(area)}});
  }
  return layer;
}

}  // namespace plumbline

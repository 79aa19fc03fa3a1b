// Features as GeoJSON, RFC 7946: of several layers each feature says which one it is of.

#include "output/json/writer.hpp"
#include "plumbline/features.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace json {
namespace {

std::string type_name(FeatureGeometry geometry) {
  switch (geometry) {
    case FeatureGeometry::Point:
      return "Point";
    case FeatureGeometry::Line:
      return "LineString";
    case FeatureGeometry::Polygon:
      return "Polygon";
  }
  return "";
}

/// The ring with its first point repeated.
std::vector<PointD> closed(const std::vector<PointD>& ring) {
  std::vector<PointD> result = ring;
  result.push_back(ring.front());
  return result;
}

auto coordinates(FeatureGeometry geometry, const Feature& feature) {
  return std::function<void(Writer&)>([geometry, &feature](Writer& writer) {
    if (geometry == FeatureGeometry::Point) {
      writer.part(member("coordinates", feature.parts[0][0]));
    } else if (geometry == FeatureGeometry::Line) {
      writer.part(member("coordinates", feature.parts[0]));
    } else {
      writer.part(member("coordinates", list(feature.parts, closed)));
    }
  });
}

auto properties(const FeatureLayer& layer, const Feature& feature, bool names_layer) {
  return object(when(names_layer, [&layer] { return member("layer", layer.name); }),
                each(Numbers(0, layer.columns.size()),
                     [&](std::size_t i) { return member(layer.columns[i], feature.values[i]); }));
}

}  // namespace
}  // namespace json

std::string to_geojson(const Features& features) {
  using namespace json;
  const bool names_layer = features.layers.size() > 1;
  std::vector<std::pair<const FeatureLayer*, const Feature*>> all;
  for (const FeatureLayer& layer : features.layers) {
    for (const Feature& feature : layer.features) all.emplace_back(&layer, &feature);
  }
  return document(object(
      member("type", "FeatureCollection"),
      when(!features.crs.empty(),
           [&] {
             return member("crs",
                           object(member("type", "name"),
                                  member("properties", object(member("name", features.crs)))));
           }),
      when(!features.note.empty(), [&] { return member("numbers", features.note); }),
      member("features", list(all, [&](const auto& entry) {
               const auto& [layer, feature] = entry;
               return object(member("type", "Feature"),
                             member("properties", properties(*layer, *feature, names_layer)),
                             member("geometry", object(member("type", type_name(layer->geometry)),
                                                       coordinates(layer->geometry, *feature))));
             }))));
}

}  // namespace plumbline

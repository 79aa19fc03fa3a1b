// Features as GeoJSON, RFC 7946: of several layers each feature says which one it is of.

#include "output/features/properties.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace json {
namespace {

/// The ring with its first point repeated.
auto closed(const std::vector<PointD>& ring) {
  return list(ring.size() + 1, [&ring](std::size_t i) { return ring[i < ring.size() ? i : 0]; });
}

auto geometry(FeatureGeometry type, const std::vector<std::vector<PointD>>& parts) {
  return object(
      member("type", type_name(type)),
      when(type == FeatureGeometry::Point, [&parts] { return member("coordinates", parts[0][0]); }),
      when(type == FeatureGeometry::Line, [&parts] { return member("coordinates", parts[0]); }),
      when(type == FeatureGeometry::Polygon, [&parts] {
        return member("coordinates", list(parts, [](const auto& ring) { return closed(ring); }));
      }));
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
  const auto row = [names_layer](const auto& entry) {
    const auto& [layer, feature] = entry;
    const auto name = [of = layer] { return member("layer", of->name); };
    return object(
        member("type", "Feature"),
        member("properties", object(when(names_layer, name), columns_of(*layer, *feature))),
        member("geometry", geometry(layer->geometry, feature->parts)));
  };
  return document(object(member("type", "FeatureCollection"), head_of(features),
                         member("features", rows(all, row))),
                  Layout::Dense, bytes_of(features));
}

}  // namespace plumbline

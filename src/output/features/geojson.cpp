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

auto placed(FeatureGeometry type, const std::vector<std::vector<PointD>>& parts) {
  return object(
      member("type", type_name(type)),
      when(type == FeatureGeometry::Point, [&parts] { return member("coordinates", parts[0][0]); }),
      when(type == FeatureGeometry::Line, [&parts] { return member("coordinates", parts[0]); }),
      when(type == FeatureGeometry::Polygon, [&parts] {
        return member("coordinates", list(parts, [](const auto& ring) { return closed(ring); }));
      }));
}

auto geometry(FeatureGeometry type, const std::vector<std::vector<PointD>>& parts) {
  return given(!parts.empty(), [type, &parts] { return placed(type, parts); });
}

/// A feature by its place in a layer.
struct Row {
  const FeatureLayer& layer;
  std::size_t place;
};

}  // namespace
}  // namespace json

std::string to_geojson(const Features& features) {
  using namespace json;
  const bool names_layer = features.layers.size() > 1;
  std::vector<Row> all;
  for (const FeatureLayer& layer : features.layers) {
    for (std::size_t i = 0; i < layer.features.size(); ++i) all.push_back({layer, i});
  }
  const auto row = [names_layer](const Row& of) {
    const Feature& feature = of.layer.features[of.place];
    const auto id = [&of] { return member("id", of.place + 1); };
    const auto name = [&of] { return member("layer", of.layer.name); };
    return object(
        member("type", "Feature"), when(of.layer.is_numbered, id),
        member("properties", object(when(names_layer, name), columns_of(of.layer, feature))),
        member("geometry", geometry(of.layer.geometry, feature.parts)));
  };
  return document(object(member("type", "FeatureCollection"), head_of(features),
                         member("features", rows(all, row))),
                  Layout::Dense, bytes_of(features));
}

}  // namespace plumbline

#pragma once

#include <string>

#include "output/json/writer.hpp"
#include "plumbline/features.hpp"

// What GeoJSON and TopoJSON say in the same words.

namespace plumbline::json {

/// "Point", "LineString", "Polygon".
inline std::string_view type_name(FeatureGeometry geometry) {
  constexpr std::array<std::string_view, 3> kNames{"Point", "LineString", "Polygon"};
  return kNames.at(static_cast<std::size_t>(geometry));
}

/// Values by the names of their columns.
inline auto columns_of(const FeatureLayer& layer, const Feature& feature) {
  return each(Numbers(0, layer.columns.size()), [&layer, &feature](std::size_t i) {
    return member(layer.columns[i], feature.values[i]);
  });
}

/// About how many bytes they take.
inline std::size_t bytes_of(const Features& features) {
  constexpr std::size_t kFeature = 100, kColumn = 20;
  std::size_t bytes = 0;
  for (const FeatureLayer& layer : features.layers) {
    bytes += layer.features.size() * (kFeature + kColumn * layer.columns.size());
  }
  return bytes;
}

/// What is to be known of all: the reference system and the note.
inline auto head_of(const Features& features) {
  return members(
      when(!features.crs.empty(),
           [&features] {
             return member("crs",
                           object(member("type", "name"),
                                  member("properties", object(member("name", features.crs)))));
           }),
      when(!features.note.empty(), [&features] { return member("numbers", features.note); }));
}

}  // namespace plumbline::json

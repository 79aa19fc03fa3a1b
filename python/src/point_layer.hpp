#pragma once

// Layers of points, as GeoPandas takes them.

#include <nanobind/stl/pair.h>
#include <nanobind/stl/variant.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core.hpp"
#include "plumbline/features.hpp"

namespace plumbline::python {

/// Columns with their names, and coordinates (n, 2), nan for what has no place.
using PointColumn = std::pair<std::string, std::vector<FeatureValue>>;
using PointTable = std::pair<std::vector<PointColumn>, DoubleArray>;

inline PointTable point_table(const FeatureLayer& layer) {
  std::vector<PointColumn> columns;
  for (std::size_t c = 0; c < layer.columns.size(); ++c) {
    std::vector<FeatureValue>& values = columns.emplace_back(layer.columns[c], 0).second;
    for (const Feature& feature : layer.features) values.push_back(feature.values.at(c));
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> coords;
  for (const Feature& feature : layer.features) {
    const PointD p = feature.parts.empty() ? PointD{kNone, kNone} : feature.parts.at(0).at(0);
    coords.insert(coords.end(), {p.x, p.y});
  }
  return {std::move(columns), array(std::move(coords), 2)};
}

}  // namespace plumbline::python

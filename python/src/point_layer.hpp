#pragma once

// Layers of points, as GeoPandas takes them.

#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "core.hpp"
#include "plumbline/features.hpp"

namespace plumbline::python {

inline nb::object value_of(const FeatureValue& value) {
  return std::visit(
      [](const auto& v) -> nb::object {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::monostate>) {
          return nb::none();
        } else {
          return nb::cast(v);
        }
      },
      value);
}

/// Columns by name, and coordinates (n, 2), nan for what has no place.
inline nb::tuple point_table(const FeatureLayer& layer) {
  nb::dict columns;
  for (std::size_t c = 0; c < layer.columns.size(); ++c) {
    nb::list values;
    for (const Feature& feature : layer.features) values.append(value_of(feature.values.at(c)));
    columns[layer.columns[c].c_str()] = values;
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> coords;
  for (const Feature& feature : layer.features) {
    const PointD p = feature.parts.empty() ? PointD{kNone, kNone} : feature.parts.at(0).at(0);
    coords.insert(coords.end(), {p.x, p.y});
  }
  return nb::make_tuple(columns, array(std::move(coords), 2));
}

/// What `point_table` returns.
#define PLUMBLINE_POINT_TABLE \
  "tuple[dict[str, list[int | float | str | None]], numpy.typing.NDArray[numpy.float64]]"

}  // namespace plumbline::python

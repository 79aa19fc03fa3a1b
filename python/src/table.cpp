// A layer of features as a table: its columns, its geometries as arrays, and as a file.

#include "table.hpp"

#include <nanobind/stl/string_view.h>
#include <nanobind/stl/variant.h>

#include <array>
#include <limits>
#include <string_view>
#include <utility>

#include "plumbline/output.hpp"

namespace plumbline::python {
namespace {

using Writer = std::string (*)(const Features&);
constexpr std::array<std::pair<std::string_view, Writer>, 6> kWriters{
    {{"geojson", to_geojson},
     {"topojson", to_topojson},
     {"dxf", to_dxf},
     {"wkt", to_wkt},
     {"csv", [](const Features& features) { return to_csv(features.layers.front()); }},
     {"wkb", to_wkb_hex}}};

std::string written(const Table& table, std::string_view format) {
  for (const auto& [known, write] : kWriters) {
    if (known == format) return write(table.features);
  }
  throw Error(ErrorCode::BadInput, "features are not written in this format", {},
              std::string(format));
}

const char* geometry_of(const Table& table) {
  switch (table.layer().geometry) {
    case FeatureGeometry::Point:
      return "point";
    case FeatureGeometry::Line:
      return "line";
    case FeatureGeometry::Polygon:
      break;
  }
  return "polygon";
}

std::vector<FeatureValue> values(const Table& table, std::size_t column) {
  const FeatureLayer& layer = table.layer();
  if (column >= layer.columns.size()) throw nb::index_error("there are fewer columns");
  std::vector<FeatureValue> result;
  result.reserve(layer.features.size());
  for (const Feature& feature : layer.features) result.push_back(feature.values.at(column));
  return result;
}

std::vector<std::string> layers(const Table& table) {
  std::vector<std::string> result;
  for (const Feature& feature : table.layer().features) result.push_back(feature.layer);
  return result;
}

/// Coordinates (n, 2), rings closed; where each part starts in them, where each feature starts in
/// the parts: as shapely.from_ragged_array takes them. A point without place is at NaN.
nb::tuple geometries(const Table& table) {
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  const FeatureLayer& layer = table.layer();
  std::vector<double> coords;
  std::vector<std::uint32_t> parts{0}, features{0};
  const auto add = [&coords](const PointD& p) { coords.insert(coords.end(), {p.x, p.y}); };
  for (const Feature& feature : layer.features) {
    for (const std::vector<PointD>& part : feature.parts) {
      for (const PointD& p : part) add(p);
      if (layer.geometry == FeatureGeometry::Polygon && !part.empty()) add(part.front());
      parts.push_back(static_cast<std::uint32_t>(coords.size() / 2));
    }
    if (layer.geometry == FeatureGeometry::Point && feature.parts.empty()) {
      add({kNowhere, kNowhere});
    }
    features.push_back(static_cast<std::uint32_t>(parts.size() - 1));
  }
  return nb::make_tuple(array(std::move(coords), 2), array(std::move(parts)),
                        array(std::move(features)));
}

}  // namespace

void bind_table(nb::module_& m) {
  nb::class_<Table>(m, "Table", "A layer of features: columns and geometries.")
      .def("__len__", [](const Table& table) { return table.layer().features.size(); })
      .def_prop_ro("geometry", &geometry_of, "\"point\", \"line\" or \"polygon\".")
      .def_prop_ro("columns", [](const Table& table) { return table.layer().columns; })
      .def("values", &values, nb::arg("column"), "Of all features, in their order.")
      .def("layers", &layers, "Per feature the layer of the drawing that it lies on.")
      .def(
          "geometries", &geometries,
          nb::sig("def geometries(self) -> tuple[numpy.typing.NDArray[numpy.float64], "
                  "numpy.typing.NDArray[numpy.uint32], numpy.typing.NDArray[numpy.uint32]]"),
          "Coordinates (n, 2), where each part starts in them, where each feature starts in these.")
      .def("written", &written, nb::arg("format"), nb::call_guard<nb::gil_scoped_release>(),
           "As geojson, topojson, dxf, wkt, csv or wkb.");
}

}  // namespace plumbline::python

// Complexes, lines and features as texts, and files that are written whole or not at all.

#include "plumbline/output.hpp"

#include <nanobind/stl/string_view.h>

#include <array>
#include <string_view>
#include <utility>

#include "core.hpp"
#include "plumbline/detail/new_file.hpp"

namespace plumbline::python {
namespace {

using FeatureWriter = std::string (*)(const Features&);
constexpr std::array<std::pair<std::string_view, FeatureWriter>, 6> kFeatureWriters{
    {{"geojson", to_geojson},
     {"topojson", to_topojson},
     {"dxf", to_dxf},
     {"wkt", to_wkt},
     {"csv", [](const Features& features) { return to_csv(features.layers.at(0)); }},
     {"wkb", to_wkb_hex}}};

/// Layers of features of `input` in a format: what there is to be said of the drawing is its.
std::string features_text(std::string_view format, std::vector<FeatureLayer> layers,
                          const SegmentSet& input, std::string note) {
  for (const auto& [known, write] : kFeatureWriters) {
    if (known != format) continue;
    if (format == "csv" && layers.size() != 1) {
      throw Error(ErrorCode::BadInput, "a .csv file holds one kind of cells");
    }
    return write({std::move(layers), input.crs, std::move(note), input.layers, input.unit});
  }
  throw Error(ErrorCode::BadInput, "this is no format of features", {}, std::string(format));
}

void bind_complex_texts(nb::module_& m) {
  m.def(
      "complex_json",
      [](const ExactComplex& complex, const SegmentSet& input, bool compact) {
        return compact ? to_compact_json(complex, input) : to_json(complex, input);
      },
      nb::arg("complex"), nb::arg("input"), nb::arg("compact"),
      nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "rounded_json",
      [](const ExactComplex& complex, const SegmentSet& input, std::optional<int> decimals,
         const Rounding& rounding) { return to_json(complex, input, {decimals}, rounding); },
      nb::arg("complex"), nb::arg("input"), nb::arg("decimals").none(), nb::arg("rounding"),
      nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "complex_svg", [](const ExactComplex& complex, bool y_up) { return to_svg(complex, y_up); },
      nb::arg("complex"), nb::arg("y_up"), nb::call_guard<nb::gil_scoped_release>());
  m.def("lar_json", &to_lar_json, nb::arg("complex"), nb::call_guard<nb::gil_scoped_release>());
  m.def("rounded_obj", &to_obj, nb::arg("rounding"), nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "complex_lines", [](const ExactComplex& complex) { return to_lines(complex); },
      nb::arg("complex"), nb::call_guard<nb::gil_scoped_release>());
  m.def("are_decimals", &are_decimals, nb::arg("complex"),
        nb::call_guard<nb::gil_scoped_release>());
  m.def("certificate_text", &certificate, nb::arg("complex"), nb::arg("input"),
        nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace

void bind_output(nb::module_& m) {
  bind_complex_texts(m);
  m.def(
      "lines_svg", [](const SegmentSet& input) { return to_svg(input); }, nb::arg("input"),
      nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "lines_text", [](const SegmentSet& input) { return to_lines(input); }, nb::arg("input"),
      nb::call_guard<nb::gil_scoped_release>());
  m.def("line_layer", &line_layer, nb::arg("lines"), nb::call_guard<nb::gil_scoped_release>());
  m.def("features_text", &features_text, nb::arg("format"), nb::arg("layers"), nb::arg("input"),
        nb::arg("note"), nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "write_file",
      [](const std::string& file, const nb::bytes& content) {
        const std::string_view text(content.c_str(), content.size());
        const nb::gil_scoped_release release;
        write_file(file, text);
      },
      nb::arg("file"), nb::arg("content"));
}

}  // namespace plumbline::python

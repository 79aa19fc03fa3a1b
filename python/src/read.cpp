// Drawings from files and texts.

#include "plumbline/read.hpp"

#include <nanobind/stl/string_view.h>

#include <array>
#include <utility>

#include "core.hpp"

namespace plumbline::python {
namespace {

using Reader = Structure (*)(std::string_view, const std::string&, const ReadOptions&);
constexpr std::array<std::pair<std::string_view, Reader>, 8> kReaders{{{"svg", read_svg},
                                                                       {"dxf", read_dxf},
                                                                       {"lines", read_lines},
                                                                       {"geojson", read_geojson},
                                                                       {"wkt", read_wkt},
                                                                       {"wkb", read_wkb},
                                                                       {"csv", read_csv},
                                                                       {"json", read_lar_json}}};

Structure read_as(std::string_view format, std::string_view text, const std::string& name,
                  const ReadOptions& options) {
  for (const auto& [known, reader] : kReaders) {
    if (known == format) return reader(text, name, options);
  }
  throw Error(ErrorCode::BadInput, "texts are not read in this format", {}, std::string(format));
}

}  // namespace

void bind_read(nb::module_& m) {
  nb::class_<ReadOptions>(m, "ReadOptions", "How a drawing is read.")
      .def(nb::init<>())
      .def_rw("format", &ReadOptions::format)
      .def_rw("chord_tolerance", &ReadOptions::chord_tolerance)
      .def_rw("hidden", &ReadOptions::hidden)
      .def_rw("layers", &ReadOptions::layers)
      .def_rw("without_layers", &ReadOptions::without_layers)
      .def_rw("hatches", &ReadOptions::hatches)
      .def_rw("layer_property", &ReadOptions::layer_property)
      .def_rw("join_curves", &ReadOptions::join_curves)
      .def_rw("shortest_decimals", &ReadOptions::shortest_decimals);
  m.def(
      "read",
      [](const std::string& file, const ReadOptions& options) { return read(file, options); },
      nb::arg("file"), nb::arg("options"), nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "read_text",
      [](std::string_view format, const nb::bytes& bytes, const std::string& name,
         const ReadOptions& options) {
        const std::string_view text(bytes.c_str(), bytes.size());
        const nb::gil_scoped_release release;
        return read_as(format, text, name, options);
      },
      nb::arg("format"), nb::arg("text"), nb::arg("name"), nb::arg("options"));
  m.def(
      "read_wkb",
      [](const nb::bytes& bytes, const std::string& name, const ReadOptions& options) {
        const std::string_view text(bytes.c_str(), bytes.size());
        const nb::gil_scoped_release release;
        return read_wkb(text, name, options);
      },
      nb::arg("bytes"), nb::arg("name"), nb::arg("options"));
}

}  // namespace plumbline::python

// Layers of features: cells of a rounded complex, with what is known of them.

#include "plumbline/features.hpp"

#include "core.hpp"

namespace plumbline::python {

void bind_features(nb::module_& m) {
  nb::class_<FeatureLayer>(m, "FeatureLayer", "Features of one kind, as all writers take them.")
      .def_ro("name", &FeatureLayer::name)
      .def_ro("columns", &FeatureLayer::columns)
      .def("__len__", [](const FeatureLayer& layer) { return layer.features.size(); });
  m.def("face_layer", &face_layer, nb::arg("complex"), nb::arg("input"), nb::arg("rounding"),
        nb::call_guard<nb::gil_scoped_release>());
  m.def("edge_layer", &edge_layer, nb::arg("input"), nb::arg("rounding"),
        nb::call_guard<nb::gil_scoped_release>());
  m.def("vertex_layer", &vertex_layer, nb::arg("rounding"),
        nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace plumbline::python

#pragma once

// A layer of features as a table: its columns, its geometries as arrays, and as a file.

#include "core.hpp"
#include "plumbline/features.hpp"

namespace plumbline::python {

/// Features of one layer, with what files say of them.
struct Table {
  Features features;

  const FeatureLayer& layer() const { return features.layers.front(); }
};

void bind_table(nb::module_& m);

}  // namespace plumbline::python

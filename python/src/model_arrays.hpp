#pragma once

// Cells of LAR models that Python gives.

#include <nanobind/stl/pair.h>

#include <utility>

#include "core.hpp"
#include "plumbline/structure/model.hpp"

namespace plumbline::python {

using Indices = nb::ndarray<const std::uint32_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using CellArrays = std::pair<Indices, Indices>;  ///< (indptr, indices)

/// Throws: Error BadInput for starts that do not fit.
Cells cells_of(const CellArrays& arrays);

}  // namespace plumbline::python

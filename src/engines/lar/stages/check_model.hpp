#pragma once

#include "plumbline/engines/lar.hpp"

namespace plumbline::lar {

/// Throws: Error BadInput for a cell without vertices, or with one that the model has not.
void check_cells(const Model& model);

}  // namespace plumbline::lar

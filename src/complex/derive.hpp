#pragma once

#include "plumbline/complex.hpp"

namespace plumbline {

/// Computes the derived members of the incidences anew from the given ones. Requires: indices in
/// range.
void derive(Incidences& complex, std::size_t vertex_count);

}  // namespace plumbline

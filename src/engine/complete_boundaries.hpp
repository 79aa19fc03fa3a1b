#pragma once

#include "plumbline/complex.hpp"

namespace plumbline {

/// The complex with what its cycles leave open filled in, as `complex_from_faces` says: its faces
/// list rings, and some halfedges and vertices are in no face. Requires: canonical order. The
/// result is not yet in canonical order.
FloatComplex complete_boundaries(const FloatComplex& complex);

}  // namespace plumbline

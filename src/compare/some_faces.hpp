#pragma once

#include "plumbline/compare.hpp"

namespace plumbline::compare_steps {

/// Holds each bounded face of a complex that lists some of the faces against the exact one: it must
/// be a face there, vertices within the tolerance, antennas of either side left out. Nothing else
/// is compared. Cost: O(n log n).
Comparison some_faces(const ExactComplex& exact_complex, const ExactComplex& other_complex,
                      double tolerance);

}  // namespace plumbline::compare_steps
